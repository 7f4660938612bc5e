// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_SHAPE_JOB_H
#define CGAL_CANONICAL_POSE_3_TOOL_SHAPE_JOB_H

#include "Child_process.h"
#include "Collection_database.h"

#include <string>
#include <vector>

namespace Canonical_pose_tool {

// What is to be computed for a shape of a collection.
struct Shape_job
{
  Shape_key key;
  std::vector<std::string> descriptors;
  std::string pose; // file to be written; empty if not requested
  bool is_segmented = false;
  std::string match; // file to be written, of a job that does only this; otherwise empty
  // As words of the command line, for `canonical-pose shape` or `match`.
  std::vector<std::string> arguments;
  Child_process::Limits limits;

  // The row of the shape after its process has ended.
  Shape_row row_of(const Child_process::Ending& ending) const;
};

// Messages between processes.
std::string to_text(const std::vector<std::string>& arguments, const Child_process::Limits& limits);
void from_text(const std::string& text, std::vector<std::string>& arguments,
               Child_process::Limits& limits);
std::string to_text(const Child_process::Ending& ending);
Child_process::Ending ending_from_text(const std::string& text);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_SHAPE_JOB_H
