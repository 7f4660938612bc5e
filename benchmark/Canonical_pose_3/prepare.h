// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

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
