// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Soup_topology.h"
#include "repaired_surface.h"
#include "selected_components.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

Repaired_surface_3 repair_surface(const Point_matrix& points, const Face_list& polygons)
{
  const internal::Checked_soup soup(points, polygons);
  return internal::repaired_surface(points, internal::Soup_topology(soup, soup.triangles()));
}

Repaired_surface_3 component_of_surface(const Repaired_surface_3& surface,
                                        const std::size_t component)
{
  if(component >= surface.number_of_components)
    throw std::invalid_argument("there is no component " + std::to_string(component)
                                + ": the surface has "
                                + std::to_string(surface.number_of_components));
  std::vector<bool> is_selected(surface.number_of_components, false);
  is_selected[component] = true;
  return internal::selected_components(surface, is_selected);
}

} // namespace Canonical_pose_3
} // namespace CGAL
