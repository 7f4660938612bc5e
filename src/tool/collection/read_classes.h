// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H
#define CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H

#include "formats/Mesh_file.h"

#include <cstddef>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

/// Returns the class of each stem, from a file of lines "stem class".
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
    std::istringstream words(lines[i]);
    std::string stem, name, more;
    if(!(words >> stem))
      continue;
    const auto where = [&] { return "'" + path + "', line " + std::to_string(i + 1); };
    if(!(words >> name) || words >> more)
      throw std::invalid_argument(where() + " is not a stem and a class");
    if(!result.emplace(stem, name).second)
      throw std::invalid_argument(where() + ": '" + stem + "' already has a class");
  }
  return result;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H
