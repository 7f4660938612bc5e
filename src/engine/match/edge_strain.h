// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_MATCH_EDGE_STRAIN_H
#define CANONICAL_POSE_3_ENGINE_MATCH_EDGE_STRAIN_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// By how much lengths of edges differ, relative to the sum of those of `points`; each in a unit of its own.
template <class Predicate>
double edge_strain(const Point_matrix& points, const double unit, const Point_matrix& matched,
                   const double unit_of_matched,
                   const std::vector<std::array<std::size_t, 3>>& triangles,
                   const Predicate& is_counted)
{
  double changes = 0, sum = 0;
  for(const std::array<std::size_t, 3>& triangle : triangles)
    for(std::size_t k = 0; k < 3 && is_counted(triangle); ++k)
    {
      const auto i = static_cast<Eigen::Index>(triangle[k]),
                 j = static_cast<Eigen::Index>(triangle[(k + 1) % 3]);
      const double length = (points.row(i) - points.row(j)).norm() / unit;
      changes += std::abs((matched.row(i) - matched.row(j)).norm() / unit_of_matched - length);
      sum += length;
    }
  return changes / sum;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_EDGE_STRAIN_H
