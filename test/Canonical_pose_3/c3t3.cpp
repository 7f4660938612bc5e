// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "c3t3.h"

#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/make_mesh_3.h>

namespace Canonical_pose_test {

C3t3 make_c3t3(int (*label)(const Mesh_3_kernel::Point_3&), const Mesh_3_kernel::Sphere_3& bounds,
               const double facet_distance)
{
  using Criteria = CGAL::Mesh_criteria_3<C3t3::Triangulation>;
  namespace params = CGAL::parameters;
  const Mesh_3_domain domain(label, bounds);
  const Criteria criteria(Criteria::Facet_criteria(25, 0.25, facet_distance),
                          Criteria::Cell_criteria(3, 0.3));
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
}

} // namespace Canonical_pose_test
