// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_LIST_COLLECTION_H
#define CGAL_CANONICAL_POSE_3_TOOL_LIST_COLLECTION_H

#include "command_options.h"
#include "collection/Collection_database.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// A text without line ends and tabs, which become \n, \r and \t, as a backslash becomes two.
std::string in_one_line(const std::string& text);

// How many of these shapes have which outcome, and the shapes without a result.
void write_summary(std::ostream& out, const std::vector<std::string>& paths,
                   std::size_t number_computed, const std::string& options,
                   Collection_database& database);

// Prints all shapes of the database, or those without a result.
void list_collection(const Arguments& arguments);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_LIST_COLLECTION_H
