// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_WITHOUT_DEGENERATE_FACES_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_WITHOUT_DEGENERATE_FACES_H

#include <CGAL/Canonical_pose_3/internal/surface/has_area.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Random.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Moves the corners of faces without area by about 1e-9 of the size of the surface, since methods that
// unfold faces refuse these.
inline Point_matrix without_degenerate_faces(Point_matrix points,
                                             const std::vector<Index_triangle>& triangles)
{
  constexpr double distance = 1e-9;
  std::vector<bool> is_moved(static_cast<std::size_t>(points.rows()), false);
  Point_matrix normalized = points;
  normalize(normalized);
  for(const Index_triangle& t : triangles)
    if(!has_area(normalized, t))
      for(const std::size_t v : t)
        is_moved[v] = true;
  Random random(0);
  const double size
    = distance * (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  for(std::size_t v = 0; v < is_moved.size(); ++v)
    if(is_moved[v])
      for(Eigen::Index k = 0; k < 3; ++k)
        points(static_cast<Eigen::Index>(v), k) += size * random.get_double(-1., 1.);
  return points;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_WITHOUT_DEGENERATE_FACES_H
