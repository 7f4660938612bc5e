// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H
#define CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace Canonical_pose_tool {

/// Returns the class of each stem, from a file of lines "stem class".
/// \throws std::invalid_argument if it cannot be read, or a line is different; the line is named.
inline std::map<std::string, std::string> read_classes(const std::string& path)
{
  std::ifstream in(path);
  if(!in)
    throw std::invalid_argument("the classes '" + path + "' cannot be read");
  std::map<std::string, std::string> result;
  std::size_t number = 0;
  for(std::string line; std::getline(in, line);)
  {
    ++number;
    std::istringstream words(line);
    std::string stem, name, more;
    if(!(words >> stem))
      continue;
    const auto where = [&] { return "'" + path + "', line " + std::to_string(number); };
    if(!(words >> name) || words >> more)
      throw std::invalid_argument(where() + " is not a stem and a class");
    if(!result.emplace(stem, name).second)
      throw std::invalid_argument(where() + ": '" + stem + "' already has a class");
  }
  return result;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_READ_CLASSES_H
