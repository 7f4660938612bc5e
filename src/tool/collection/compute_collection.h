// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_COLLECTION_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_COLLECTION_H

#include "command_options.h"
#include "collection/run_jobs.h"

namespace Canonical_pose_tool {

// Computes what shapes still need, and prints a summary; by processes, or by ranks if `run_by_mpi` is not empty.
void compute_collection(const Arguments& arguments, const Run_jobs& run_by_mpi);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_COLLECTION_H
