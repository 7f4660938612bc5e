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
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// The files that a run leaves: all of them whole, or none. They are written beside their places
// under
// names of their own, and renamed together.
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

  // Writes the file for `path`, if that is not empty, beside its place.
  // Throws std::runtime_error if it cannot be written.
  void write(const std::string& path, const std::function<void(std::ostream&)>& write_to);

  // Puts all files in their places.
  void commit();

private:
  struct File
  {
    std::filesystem::path place, beside;
  };

  std::vector<File> m_files;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H
