// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "examine_surface.h"
#include "Soup_diagnosis.h"
#include "Soup_topology.h"
#include "repaired_surface.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Examined_surface examine_surface(const Point_matrix& points, const Face_list& polygons,
                                 const bool searches_self_intersections)
{
  const Checked_soup soup(points, polygons);
  const Soup_topology topology(soup, soup.triangles());
  Examined_surface result;
  // The edges of polygons that were cut or removed are not those of the triangles.
  result.diagnosis = soup.is_triangulated()
                       ? diagnosis_of(topology, searches_self_intersections)
                       : diagnosis_of(Soup_topology(soup, polygons), searches_self_intersections);
  result.surface = repaired_surface(points, topology);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
