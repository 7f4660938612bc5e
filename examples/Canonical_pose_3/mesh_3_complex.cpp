// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The canonical pose of a tetrahedral mesh of an implicit solid, created by Mesh_3: a sausage bent
// to a half circle is straightened.

#include <CGAL/canonical_pose_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <unordered_map>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;

double sausage(const Point_3& p) // negative inside
{
  const double y = (std::min)(p.y(), 0.), ring = std::hypot(p.x(), p.y() - y) - 3;
  return std::hypot(ring, y, p.z()) - 0.6;
}

int main()
{
  const Kernel::Sphere_3 around(Point_3(0, 3, 0), 36.); // its center is inside; squared radius
  const Domain domain = Domain::create_implicit_mesh_domain(&sausage, around);
  const Criteria criteria(Criteria::Facet_criteria(25, 0.25, 0.02),
                          Criteria::Cell_criteria(3, 0.3));
  using namespace CGAL::parameters; // without optimizers, Mesh_3 is deterministic
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, no_perturb(), no_exude());
  std::unordered_map<C3t3::Vertex_handle, Point_3> pose;
  const auto summary = CGAL::canonical_pose_3(c3t3, boost::make_assoc_property_map(pose)).summary;
  double before = 0, after = 0; // squared diameters
  for(const auto& [v, p] : pose)
    for(const auto& [w, q] : pose)
    {
      before = (std::max)(before, CGAL::squared_distance(v->point().point(), w->point().point()));
      after = (std::max)(after, CGAL::squared_distance(p, q));
    }
  std::cout << summary << '\n'
            << "diameter " << std::sqrt(before) << " -> " << std::sqrt(after) << '\n';
  // by default, no cell is inverted
  return summary.is_usable() && summary.inverted == 0 && after > 1.5 * before ? EXIT_SUCCESS
                                                                              : EXIT_FAILURE;
}
