// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_WAVEFRONT_WAVEFRONT_SOLVER_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_WAVEFRONT_WAVEFRONT_SOLVER_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Distances by wavefronts on the intrinsic Delaunay triangulation of a surface.
class Wavefront_solver
{
public:
  Wavefront_solver(const Face_corners& corners, const Point_matrix& points);

  // One column per source (a row of the points): n distances in the unit of the input.
  Eigen::MatrixXd distances(const std::vector<int>& sources) const;

  // Distances to the nearest of the sources, in the unit of the input.
  Eigen::VectorXd distance_to_nearest(const std::vector<int>& sources) const;

private:
  class Waves;

  std::shared_ptr<const Waves> m_waves;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_WAVEFRONT_WAVEFRONT_SOLVER_H
