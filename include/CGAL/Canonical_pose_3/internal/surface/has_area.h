// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_HAS_AREA_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_HAS_AREA_H

#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether a triangle has an area: its height is above rounding errors, relative to its longest edge.
// The squares of the coordinates must be in the range of `double`.
template <class Points>
bool has_area(const Points& points, const std::array<std::size_t, 3>& t)
{
  constexpr double flatness = 1e-10;
  const auto squared_length = [&](const std::size_t k, const std::size_t l) {
    return (points.row(static_cast<Eigen::Index>(t[k]))
            - points.row(static_cast<Eigen::Index>(t[l])))
      .squaredNorm();
  };
  return twice_area(points, t)
         > flatness
             * (std::max)({squared_length(0, 1), squared_length(1, 2), squared_length(2, 0)});
}

template <class Points>
bool has_area(const Points& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  return std::any_of(triangles.begin(), triangles.end(),
                     [&](const auto& t) { return has_area(points, t); });
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_HAS_AREA_H
