// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMMANDS_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMMANDS_H

#include "Command_line.h"

namespace Canonical_pose_tool {

// The commands. Each throws an exception on failure.

void run_pose(Arguments& arguments);
void run_check(const Arguments& arguments);
void run_geodesics(const Arguments& arguments);
void run_compare(const Arguments& arguments);
void run_segment(const Arguments& arguments);
void run_page(const Arguments& arguments);
void run_describe(const Arguments& arguments);
void run_collection(const Arguments& arguments);
void run_shape(const Arguments& arguments);
void run_search(const Arguments& arguments);
void run_evaluate(const Arguments& arguments);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMMANDS_H
