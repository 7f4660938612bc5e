// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H
#define CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H

#include "formats/Mesh_file.h"

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

/// Returns a text without blanks at both ends.
inline std::string trimmed(const std::string& text)
{
  const char* const blanks = " \t\r\v\f";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Returns the class of each stem, from a file of lines "stem class". What is between them is the first
/// tab, if there is one, otherwise the last blank: the other part may have blanks.
/// \throws std::invalid_argument if it cannot be read, or a line is different; the line is named.
inline std::map<std::string, std::string> read_classes(const std::string& path)
{
  std::vector<std::string> lines;
  try
  {
    lines = read_lines(path);
  }
  catch(const std::invalid_argument& error)
  {
    throw std::invalid_argument("the classes '" + path + "' cannot be read: " + error.what());
  }
  std::map<std::string, std::string> result;
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    const std::string line = trimmed(lines[i]);
    if(line.empty())
      continue;
    const auto where = [&] { return "'" + path + "', line " + std::to_string(i + 1); };
    std::size_t separator = line.find('\t');
    if(separator == std::string::npos)
      separator = line.rfind(' ');
    if(separator == std::string::npos)
      throw std::invalid_argument(where() + " is not a stem and a class");
    const std::string stem = trimmed(line.substr(0, separator)),
                      name = trimmed(line.substr(separator + 1));
    if(!result.emplace(stem, name).second)
      throw std::invalid_argument(where() + ": '" + stem + "' already has a class");
  }
  return result;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H
