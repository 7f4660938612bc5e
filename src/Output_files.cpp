// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include "Output_files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

std::string cannot_write(const std::string& path, const std::string& reason)
{
  return "'" + path + "' cannot be written: " + reason;
}

// The file behind symbolic links, since a renamed file would take the place of the link.
fs::path place_of(const std::string& path)
{
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::absolute(path) : place;
}

} // namespace

Output_files::Output_files(const std::vector<std::string>& paths)
{
  std::set<fs::path> places;
  for(const std::string& path : paths)
  {
    if(path.empty())
      continue;
    const fs::path place = place_of(path);
    std::error_code error;
    if(fs::exists(place, error) && !fs::is_regular_file(place, error))
      throw std::invalid_argument(cannot_write(path, "it is not a file"));
    if(!fs::is_directory(place.parent_path(), error))
      throw std::invalid_argument(cannot_write(path, "there is no such directory"));
    if(access(place.parent_path().c_str(), W_OK) != 0)
      throw std::invalid_argument(cannot_write(path, "the directory cannot be written to"));
    if(!places.insert(place).second)
      throw std::invalid_argument(cannot_write(path, "another output has the same name"));
  }
}

Output_files::~Output_files()
{
  std::error_code error;
  for(const File& file : m_files)
    fs::remove(file.beside, error);
}

void Output_files::write(const std::string& path,
                         const std::function<void(std::ostream&)>& write_to)
{
  if(path.empty())
    return;
  const fs::path place = place_of(path);
  fs::path beside = place;
  beside += ".part-" + std::to_string(getpid());
  errno = 0;
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  if(out)
  {
    m_files.push_back({place, beside});
    write_to(out);
    out.close();
  }
  if(!out)
    throw std::runtime_error(
      cannot_write(path, errno != 0 ? std::strerror(errno) : "the disk may be full"));
}

void Output_files::commit()
{
  for(const File& file : m_files)
    fs::rename(file.beside, file.place);
  m_files.clear();
}

} // namespace Canonical_pose_tool
