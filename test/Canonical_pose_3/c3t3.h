// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Complexes of Mesh_3, compiled once.

#ifndef CGAL_CANONICAL_POSE_3_TEST_C3T3_H
#define CGAL_CANONICAL_POSE_3_TEST_C3T3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>

namespace Canonical_pose_test {

using Mesh_3_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh_3_domain = CGAL::Labeled_mesh_domain_3<Mesh_3_kernel>;
using C3t3
  = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Mesh_triangulation_3<Mesh_3_domain>::type>;

// Fills the points whose label is not 0; the center of the sphere is one of them.
C3t3 make_c3t3(int (*label)(const Mesh_3_kernel::Point_3&), const Mesh_3_kernel::Sphere_3& bounds,
               double facet_distance);

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_C3T3_H
