// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Soup_topology.h"
#include "repaired_surface.h"

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

template <class Polygons>
Repaired_surface_3 repair_soup(const Point_matrix& points, const Polygons& polygons)
{
  const Checked_soup soup(points, polygons);
  return repaired_surface(points, Soup_topology(soup, soup.triangles().triangles));
}

} // namespace internal

Repaired_surface_3 repair_surface(const Point_matrix& points,
                                  const std::vector<std::vector<std::size_t>>& polygons)
{
  return internal::repair_soup(points, polygons);
}

Repaired_surface_3 repair_surface(const Point_matrix& points,
                                  const std::vector<std::array<std::size_t, 3>>& triangles)
{
  return internal::repair_soup(points, triangles);
}

} // namespace Canonical_pose_3
} // namespace CGAL
