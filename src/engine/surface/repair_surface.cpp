// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Soup_topology.h"
#include "repaired_surface.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

namespace CGAL {
namespace Canonical_pose_3 {
Repaired_surface_3 repair_surface(const Point_matrix& points, const Face_list& polygons)
{
  const internal::Checked_soup soup(points, polygons);
  return internal::repaired_surface(points, internal::Soup_topology(soup, soup.triangles()));
}

} // namespace Canonical_pose_3
} // namespace CGAL
