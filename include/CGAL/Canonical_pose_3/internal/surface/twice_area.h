// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TWICE_AREA_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TWICE_AREA_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Twice the area of a triangle.
template <class Points>
double twice_area(const Points& points, const std::array<std::size_t, 3>& t)
{
  const auto corner = [&](const std::size_t k) -> Eigen::Vector3d {
    return points.row(static_cast<Eigen::Index>(t[k]));
  };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
}

template <class Points>
double area(const Points& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  double result = 0;
  for(const auto& t : triangles)
    result += twice_area(points, t) / 2;
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TWICE_AREA_H
