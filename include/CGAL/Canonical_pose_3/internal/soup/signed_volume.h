// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_SIGNED_VOLUME_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_SIGNED_VOLUME_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
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
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_SIGNED_VOLUME_H
