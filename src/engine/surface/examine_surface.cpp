// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "examine_surface.h"
#include "Soup_diagnosis.h"
#include "Soup_topology.h"
#include "repaired_surface.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Examined_surface examine_surface(const Point_matrix& points,
                                 const std::vector<std::vector<std::size_t>>& polygons)
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
} // namespace Canonical_pose_3
} // namespace CGAL
