// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_RUN_JOBS_H
#define CGAL_CANONICAL_POSE_3_TOOL_RUN_JOBS_H

#include "Shape_job.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace Canonical_pose_tool {

// Receives how a job ended; called one at a time.
using Job_ended = std::function<void(const Shape_job& job, const Child_process::Ending& ending)>;

// Runs all jobs, so many at a time.
void run_jobs(const std::vector<Shape_job>& jobs, std::size_t number_of_workers,
              const Job_ended& ended);

using Run_jobs = std::function<void(const std::vector<Shape_job>& jobs, const Job_ended& ended)>;

// Started by MPI on several ranks, calls `on_first_rank` on the first one, with a function that lets the
// others run the jobs, one at a time each. Otherwise calls it with an empty function.
void with_mpi(const std::function<void(const Run_jobs& run)>& on_first_rank);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_RUN_JOBS_H
