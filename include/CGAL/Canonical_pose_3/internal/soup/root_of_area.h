// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_ROOT_OF_AREA_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_ROOT_OF_AREA_H

#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The square root of the area of triangles, which is in the range of `double` whenever the points
// are.
inline double root_of_area(Point_matrix points, const std::vector<Index_triangle>& triangles)
{
  const int exponent = normalize(points);
  return std::ldexp(std::sqrt(area(points, triangles)), exponent);
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_ROOT_OF_AREA_H
