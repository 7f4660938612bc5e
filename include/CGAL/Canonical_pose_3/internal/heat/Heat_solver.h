// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_HEAT_HEAT_SOLVER_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_HEAT_HEAT_SOLVER_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The heat method on an intrinsic Delaunay triangulation: heat diffuses from the source for a short
// time, and the distance is the function whose gradient follows the descent directions of the heat.
class Heat_solver : public Distance_solver
{
public:
  virtual const Intrinsic_triangulation& triangulation() const = 0;
};

// `time_step_factor`: the time step by the square of the mean edge length; see heat_lengths().
// Throws `std::invalid_argument` if it is out of its bounds, or when no face has an area.
std::unique_ptr<Heat_solver> make_heat_solver(const Face_corners& corners,
                                              const Point_matrix& points, double time_step_factor,
                                              Factor_maker factor_maker);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_HEAT_HEAT_SOLVER_H
