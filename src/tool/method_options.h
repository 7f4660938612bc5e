// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_METHOD_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_TOOL_METHOD_OPTIONS_H

#include <CGAL/Canonical_pose_3/Options.h>

#include <functional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// An option of the library that has one value, as the program and the Python module take it.
struct Method_option
{
  enum class Type { CHOICE, INTEGER, NUMBER };

  std::string name; // of the program, without "--"; in Python, with '_' for '-'
  std::string help;
  Type type;
  std::vector<std::string> choices;
  std::string range; // what a value must be, for messages

  // Sets the option to the value of a text. Returns false if it is not in the range.
  std::function<bool(CGAL::Canonical_pose_3::Options& options, const std::string& text)> set;
  // The value as a text; empty if it is not set, so that it depends on other options.
  std::function<std::string(const CGAL::Canonical_pose_3::Options& options)> value;
};

// All of them, in the order of the help.
const std::vector<Method_option>& method_options();

// Throws std::out_of_range if there is none of this name.
const Method_option& method_option(const std::string& name);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_METHOD_OPTIONS_H
