// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_MESH_FILES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_MESH_FILES_H

#include "formats/Mesh_file.h" // of the tool

#include <algorithm>
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

inline bool has_known_format(const std::filesystem::path& file)
{
  try
  {
    Canonical_pose_tool::format_of(file.string());
    return true;
  }
  catch(const std::invalid_argument&)
  {
    return false;
  }
}

/// Returns the files among `places`, and those with a known format in the folders among them, whose
/// name contains a match of `filter`.
inline std::vector<std::filesystem::path> mesh_files(const std::vector<std::string>& places,
                                                     const std::regex& filter)
{
  std::vector<std::filesystem::path> result;
  for(const std::filesystem::path place : places)
  {
    std::vector<std::filesystem::path> files;
    if(std::filesystem::is_directory(place))
      for(const auto& entry : std::filesystem::directory_iterator(place))
      {
        if(has_known_format(entry.path()))
          files.push_back(entry.path());
      }
    else if(std::filesystem::exists(place))
      files.push_back(place);
    else
      throw std::invalid_argument("there is no " + place.string());
    std::sort(files.begin(), files.end());
    for(const std::filesystem::path& file : files)
      if(std::regex_search(file.filename().string(), filter))
        result.push_back(file);
  }
  return result;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_MESH_FILES_H
