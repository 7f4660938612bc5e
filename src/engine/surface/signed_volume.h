// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SIGNED_VOLUME_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SIGNED_VOLUME_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Six times the volume inside the triangles; summed relative to the extent, so that it is accurate
// in any unit.
inline double signed_volume(const Point_matrix& points,
                            const std::vector<std::array<std::size_t, 3>>& triangles)
{
  const Eigen::RowVector3d center = points.colwise().mean();
  const double extent = (points.rowwise() - center).cwiseAbs().maxCoeff();
  double sum = 0;
  for(const auto& t : triangles)
  {
    Eigen::Matrix3d corners;
    for(int k = 0; k < 3; ++k)
      corners.row(k) = (points.row(static_cast<Eigen::Index>(t[k])) - center) / extent;
    sum += corners.determinant();
  }
  return sum * extent * extent * extent;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SIGNED_VOLUME_H
