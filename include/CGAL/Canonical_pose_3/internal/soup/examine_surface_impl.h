// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_EXAMINE_SURFACE_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_EXAMINE_SURFACE_IMPL_H

#include <CGAL/Canonical_pose_3/internal/soup/Soup_topology.h>
#include <CGAL/Canonical_pose_3/internal/soup/diagnose_impl.h>
#include <CGAL/Canonical_pose_3/internal/soup/examine_surface.h>
#include <CGAL/Canonical_pose_3/internal/soup/repair_surface_impl.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

CGAL_CANONICAL_POSE_3_INLINE Examined_surface
examine_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons)
{
  const Checked_soup soup(points, polygons);
  const Soup_topology topology(soup, soup.triangles().triangles);
  Examined_surface result;
  // The edges of polygons that were cut or removed are not those of the triangles.
  result.diagnosis
    = soup.is_triangulated() ? diagnosis_of(topology) : diagnosis_of(Soup_topology(soup, polygons));
  result.surface = repaired_surface(points, topology);
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_EXAMINE_SURFACE_IMPL_H
