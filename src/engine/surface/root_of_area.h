// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_ROOT_OF_AREA_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_ROOT_OF_AREA_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The square root of the area of triangles, which is in the range of `double` whenever the points
// are.
inline double root_of_area(Point_matrix points, const std::vector<Index_triangle>& triangles)
{
  const int exponent = normalize(points);
  return std::ldexp(std::sqrt(area(points, triangles)), exponent);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_ROOT_OF_AREA_H
