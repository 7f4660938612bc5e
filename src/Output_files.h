// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H
#define CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// The files that a run leaves: all of them whole, or none. They are written beside their places
// under names that nobody uses, and renamed together. Symbolic links are followed, whether there is
// a file behind them or not.
class Output_files
{
public:
  // Checks that files could be written to `paths`, empty ones left out. Writes nothing.
  // Throws std::invalid_argument that names the path.
  explicit Output_files(const std::vector<std::string>& paths);

  // Removes what was not committed.
  ~Output_files();

  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  // Writes the file for `path`, one of those that were checked, beside its place; an empty path is
  // left out.
  // Throws std::runtime_error if it cannot be written.
  void write(const std::string& path, const std::function<void(std::ostream&)>& write_to);

  // Puts all files in their places.
  // Throws std::runtime_error if one cannot be put there; the others then are as they were before.
  void commit();

private:
  struct File
  {
    std::string path;
    std::filesystem::path place, beside;
    // Another name of what is there and will be replaced; empty if there is nothing.
    std::filesystem::path before = {};
    bool is_new = true;
  };

  void keep_what_is_there();
  void undo(std::size_t number_of_renamed_files);

  std::map<std::string, std::filesystem::path> m_places;
  std::vector<File> m_files;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H
