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
#include <CGAL/Canonical_pose_3/internal/soup/Soup_topology.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
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

// `points`: the given ones. `topology`: that of the triangles of its soup.
inline Repaired_surface_3
repaired_surface(const Point_matrix& points,
                 const Soup_topology<std::vector<Index_triangle>>& topology)
{
  if(!topology.soup.has_faces())
    throw std::invalid_argument(Checked_soup::NO_FACE);
  Repaired_surface_3 result;
  Manifold_builder builder(topology);
  builder.run(result);
  result.points = rows_at(points, result.origins);
  Component_orienter(rows_at(topology.soup.points(), result.origins), builder.twins(), result)
    .run();
  return result;
}

template <class Polygons>
Repaired_surface_3 repair_soup(const Point_matrix& points, const Polygons& polygons)
{
  const Checked_soup soup(points, polygons);
  return repaired_surface(points, Soup_topology(soup, soup.triangles().triangles));
}

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
