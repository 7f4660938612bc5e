// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_REPAIR_SURFACE_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_REPAIR_SURFACE_IMPL_H

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/soup/Component_orienter.h>
#include <CGAL/Canonical_pose_3/internal/soup/Manifold_builder.h>
#include <CGAL/Canonical_pose_3/internal/soup/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

template <class Polygons>
Repaired_surface_3 repair_soup(const Point_matrix& points, const Polygons& polygons)
{
  check_soup(points, polygons);
  if(polygons.empty())
    throw std::invalid_argument("the surface has no face");
  Point_matrix normalized = points;
  normalize(normalized);
  Repaired_surface_3 result;
  Manifold_builder builder(normalized, triangle_soup(normalized, polygons));
  builder.run(result);
  const std::size_t n = result.origins.size();
  result.points.resize(static_cast<Eigen::Index>(n), 3);
  Point_matrix normalized_copies(result.points.rows(), 3);
  for(std::size_t v = 0; v < n; ++v)
  {
    const Eigen::Index row = static_cast<Eigen::Index>(v),
                       origin = static_cast<Eigen::Index>(result.origins[v]);
    result.points.row(row) = points.row(origin);
    normalized_copies.row(row) = normalized.row(origin);
  }
  Component_orienter(normalized_copies, builder.twins(), result).run();
  return result;
}

// The first copy of each row of the input; the number of vertices of the surface where there is none.
} // namespace internal

CGAL_CANONICAL_POSE_3_INLINE Repaired_surface_3
repair_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons)
{
  return internal::repair_soup(points, polygons);
}

CGAL_CANONICAL_POSE_3_INLINE Repaired_surface_3
repair_surface(const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  return internal::repair_soup(points, triangles);
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_REPAIR_SURFACE_IMPL_H
