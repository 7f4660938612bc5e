// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_DISTANCE_SOLVER_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_DISTANCE_SOLVER_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Distances on a surface, in the unit of its points; infinite between vertices that are not connected.
// Sources are rows of the points, and may repeat.
class Distance_solver
{
public:
  virtual ~Distance_solver() = default;

  // One column per source.
  virtual Eigen::MatrixXd distances(const std::vector<Eigen::Index>& sources) const = 0;

  // Distances from the nearest of the sources.
  virtual Eigen::VectorXd distance_to_nearest(const std::vector<Eigen::Index>& sources) const = 0;
};

// By wavefronts, see Wavefront_geodesics_3.
std::unique_ptr<Distance_solver> make_wavefront_solver(const Face_corners& corners,
                                                       const Point_matrix& points);

// By CGAL's shortest paths, see Exact_geodesics_3.
std::unique_ptr<Distance_solver> make_exact_solver(const Face_corners& corners,
                                                   const Point_matrix& points);

// See Biharmonic_distances_3.
std::unique_ptr<Distance_solver> make_biharmonic_solver(const Face_corners& corners,
                                                        const Point_matrix& points,
                                                        std::size_t number_of_eigenfunctions,
                                                        Factor_maker factor_maker);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_DISTANCE_SOLVER_H
