// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: unsupported complexes are refused by a message, see test_refusals.cmake.

#include <CGAL/Canonical_pose_3/Labeled_cells_3.h>
#include <CGAL/Canonical_pose_3/complex_body.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <map>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct My_complex
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<int, 4>> cells;
};

template <>
struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3<My_complex>
{
  using Vertex_descriptor = int;
  using Point_3 = Kernel::Point_3;
  static std::vector<int> vertices(const My_complex&);
  static const std::vector<std::array<int, 4>>& cells(const My_complex& complex);
  static const Point_3& point(const My_complex& complex, int v);
};

void refused(const Triangulation& triangulation, const My_complex& complex)
{
  std::map<Triangulation::Vertex_handle, Kernel::Point_3> pose;
  std::map<Mesh::Vertex_index, Triangulation::Vertex_handle> origin;
  Mesh mesh;
  CGAL::Canonical_pose_3::complex_body(CGAL::Canonical_pose_3::Labeled_cells_3(complex, 1));
  CGAL::canonical_pose_3(triangulation, boost::make_assoc_property_map(pose));
  CGAL::Canonical_pose_3::complex_body(triangulation);
  CGAL::Canonical_pose_3::extract_boundary(triangulation, mesh,
                                           boost::make_assoc_property_map(origin));
}
