// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_PREPARE_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_PREPARE_H

#include "Body_trial.h"

namespace Canonical_pose_benchmark {

/// Computes distances and the first target as the package does by default, except that distances are
/// computed on the surface itself; in a separate process, since this one must not have threads.
Body_problem prepare(const Point_matrix& points, const Triangles& triangles,
                     const Triangles& caps = Triangles());

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_PREPARE_H
