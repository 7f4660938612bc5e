// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COLLECTION_JOBS_H
#define CGAL_CANONICAL_POSE_3_TOOL_COLLECTION_JOBS_H

#include "command_options.h"
#include "descriptors.h"
#include "collection/Collection_database.h"
#include "collection/Shape_job.h"

#include <optional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// Where the pose of a shape is written: in the format of the shape, so that nothing of it is lost.
std::string pose_file(const Arguments& arguments, const std::string& path);

// Throws std::invalid_argument if an output would replace another one, or an input.
void check_output_files(const Arguments& arguments, const std::vector<std::string>& paths);

// What is still to be done for a shape, if anything, but for its match.
std::optional<Shape_job> job_of(const std::string& path, const Arguments& arguments,
                                const std::vector<Descriptor>& requested,
                                const std::string& checksum_of_template,
                                Collection_database& database);

// The match of a shape that has a pose, unless it is up to date.
std::optional<Shape_job> match_job_of(const std::string& path, const Arguments& arguments,
                                      const std::string& checksum_of_template,
                                      Collection_database& database);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COLLECTION_JOBS_H
