// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_FILE_STREAM_H
#define CGAL_CANONICAL_POSE_3_TOOL_FILE_STREAM_H

#include <filesystem>
#include <map>
#include <ostream>
#include <streambuf>
#include <string>
#include <utility>

namespace Canonical_pose_tool {

// A stream to a file that has others beside it, for instance materials. They are written after it.
class File_stream : public std::ostream
{
public:
  // `path`: where the file will be.
  File_stream(std::streambuf* const buffer, std::filesystem::path path)
    : std::ostream(buffer), m_path(std::move(path))
  {}

  const std::filesystem::path& path() const { return m_path; }

  void add_file_beside(const std::string& name, std::string content)
  {
    m_files_beside[name] = std::move(content);
  }

  // Contents by names.
  const std::map<std::string, std::string>& files_beside() const { return m_files_beside; }

private:
  std::filesystem::path m_path;
  std::map<std::string, std::string> m_files_beside;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_FILE_STREAM_H
