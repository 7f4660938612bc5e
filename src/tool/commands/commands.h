// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMMANDS_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMMANDS_H

#include "Command_line.h"

#include <vector>

namespace Canonical_pose_tool {

struct Command_options;

// A command of the tool. Each is defined in a source with its name.
struct Command
{
  const char* name;
  const char* summary;               // empty: not shown
  std::vector<const char*> examples; // without the name of the tool
  void (*add_options)(Command_options&);
  int (*run)(Arguments&); // returns the exit code; throws an exception on failure
};

extern const Command POSE_COMMAND, SEGMENT_COMMAND, DESCRIBE_COMMAND, COLLECTION_COMMAND,
  SEARCH_COMMAND, EVALUATE_COMMAND, CHECK_COMMAND, COMPARE_COMMAND, GEODESICS_COMMAND,
  MATCH_COMMAND, PAGE_COMMAND, SHAPE_COMMAND;

// In the order of --help.
extern const std::vector<const Command*> COMMANDS;

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMMANDS_H
