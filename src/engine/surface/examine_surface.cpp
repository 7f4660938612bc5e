// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "examine_surface.h"
#include "Soup_diagnosis.h"
#include "Soup_topology.h"
#include "repaired_surface.h"

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

template <class Polygons>
Examined_surface examined_soup(const Point_matrix& points, const Polygons& polygons,
                               const bool searches_self_intersections)
{
  const Checked_soup soup(points, polygons);
  const Soup_topology topology(soup, soup.triangles().triangles);
  Examined_surface result;
  // The edges of polygons that were cut or removed are not those of the triangles.
  result.diagnosis = soup.is_triangulated()
                       ? diagnosis_of(topology, searches_self_intersections)
                       : diagnosis_of(Soup_topology(soup, polygons), searches_self_intersections);
  result.surface = repaired_surface(points, topology);
  return result;
}

Examined_surface examine_surface(const Point_matrix& points,
                                 const std::vector<std::vector<std::size_t>>& polygons,
                                 const bool searches_self_intersections)
{
  return examined_soup(points, polygons, searches_self_intersections);
}

Examined_surface examine_surface(const Point_matrix& points,
                                 const std::vector<Index_triangle>& triangles,
                                 const bool searches_self_intersections)
{
  return examined_soup(points, triangles, searches_self_intersections);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
