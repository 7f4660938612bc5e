// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/complex_body.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/property_map.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <gtest/gtest.h>

#include "c3t3.h"
#include "matchers.h"
#include "shapes.h"

#include <limits>
#include <unordered_map>
#include <vector>

namespace test_tetrahedral_complex {

namespace CP = CGAL::Canonical_pose_3;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Tetrahedra = CP::Indexed_tetrahedra_3<Point>;

Tetrahedra indexed(const Canonical_pose_test::Tetrahedral_soup& soup)
{
  Tetrahedra result;
  for(const auto& p : soup.points)
    result.points.emplace_back(p[0], p[1], p[2]);
  result.cells = soup.cells;
  return result;
}

// The boundary with the corresponding vertices of the complex; each vertex must have the position
// of its origin.
template <class Complex>
Mesh checked_boundary(const Complex& complex)
{
  using Traits = CP::Tetrahedral_complex_traits_3<Complex>;
  Mesh mesh;
  auto origin
    = mesh.add_property_map<Mesh::Vertex_index, typename Traits::Vertex_descriptor>("v:origin")
        .first;
  CP::extract_boundary(complex, mesh, origin);
  for(const auto v : mesh.vertices())
    EXPECT_EQ(mesh.point(v), Traits::point(complex, origin[v]));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  return mesh;
}

// The volume inside the outward boundary is the sum of the volumes of the cells (divergence
// theorem).
template <class Complex>
void expect_same_volume(const Complex& complex)
{
  const CP::Conforming_body_3 body = CP::complex_body(complex);
  EXPECT_NEAR(body.cell_weights().sum(), 1., 1e-12);
  EXPECT_NEAR(PMP::volume(checked_boundary(complex)), body.volume(), 1e-10 * body.volume());
}

// A box of 3x2x4 cubes of six tetrahedra each, with every other cell inverted: orientation must not
// matter.
TEST(Tetrahedral_complex, indexed_cells_in_any_orientation)
{
  Tetrahedra box = indexed(Canonical_pose_test::tetrahedral_box(3, 2, 4, {{1., 2., 3.}}));
  for(std::size_t t = 0; t < box.cells.size(); t += 2)
    std::swap(box.cells[t][0], box.cells[t][1]);
  expect_same_volume(box);
  EXPECT_NEAR(CP::complex_body(box).volume(), 6., 1e-12);
  const Mesh boundary = checked_boundary(box);
  EXPECT_EQ(boundary.number_of_faces(), 2u * 2 * (3 * 2 + 2 * 4 + 3 * 4));
  EXPECT_EQ(boundary.number_of_vertices(), 4u * 3 * 5 - 2u * 1 * 3); // all except interior ones
}

// Two cells that share only an edge: the boundary is split there into two closed surfaces, so that
// the two vertices of the edge have two copies each.
TEST(Tetrahedral_complex, boundary_is_split_where_it_is_not_manifold)
{
  Tetrahedra pair;
  pair.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  pair.cells = {{{0, 1, 2, 3}}, {{0, 1, 4, 5}}};
  const Mesh boundary = checked_boundary(pair);
  EXPECT_EQ(boundary.number_of_vertices(), 8u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(boundary));
}

TEST(Tetrahedral_complex, mesh_3_complex)
{
  const auto label = [](const Point& p) {
    return CGAL::to_double(p.x() * p.x() + p.y() * p.y() + 4 * p.z() * p.z()) < 1 ? 1 : 0;
  };
  const auto c3t3 = Canonical_pose_test::make_c3t3(label, Kernel::Sphere_3(CGAL::ORIGIN, 4.), 0.02);
  expect_same_volume(c3t3);
  // An ellipsoid of half axes 1, 1, 1/2, inscribed.
  EXPECT_NEAR(CP::complex_body(c3t3).volume(), 2. / 3 * Canonical_pose_test::pi, 0.1);
}

// The cells of a Delaunay triangulation of a grid tile its hull: the volume of the cells in the
// complex is known.
TEST(Tetrahedral_complex, triangulation_with_subdomains)
{
  using Remeshing_triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>;
  CGAL::Delaunay_triangulation_3<Kernel, Remeshing_triangulation::Triangulation_data_structure> tr;
  for(const auto& p : Canonical_pose_test::tetrahedral_box(4, 4, 4).points)
    tr.insert(Point(p[0], p[1], p[2]));
  for(const auto cell : tr.finite_cell_handles())
  {
    double x = 0;
    for(int k = 0; k < 4; ++k)
      x += cell->vertex(k)->point().x() / 4;
    cell->set_subdomain_index(x < 0.5 ? 1 : 0);
  }
  expect_same_volume(tr);
  EXPECT_NEAR(CP::complex_body(tr).volume(), 0.5, 1e-12);
  EXPECT_EQ(CP::complex_body(tr).points().rows(), 3 * 5 * 5);

  Remeshing_triangulation copy;
  copy.tds() = tr.tds();
  copy.set_infinite_vertex(copy.tds().vertices_begin());
  expect_same_volume(copy);
}

TEST(Conforming_body, bad_input_is_named)
{
  Tetrahedra box = indexed(Canonical_pose_test::tetrahedral_box(1, 1, 1));
  Tetrahedra bad = box;
  bad.cells[2][3] = 8;
  EXPECT_THROW_WITH(CP::complex_body(bad), std::invalid_argument, "cell 2 names a vertex");
  bad = box;
  bad.cells[4][1] = bad.cells[4][0];
  EXPECT_THROW_WITH(CP::complex_body(bad), std::invalid_argument, "cell 4 names a vertex twice");
  bad = box;
  bad.cells[4] = {{0, 1, 2, 3}}; // the bottom
  EXPECT_THROW_WITH(CP::complex_body(bad), std::invalid_argument, "cell 4 has no volume");
  bad = box;
  bad.points[5] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_THROW_WITH(CP::complex_body(bad), std::invalid_argument,
                    "vertex 5 has a coordinate that is not finite");
  bad = box;
  bad.cells.push_back({{0, 1, 3, 2}});
  bad.cells.push_back({{0, 1, 3, 4}});
  bad.cells.push_back({{0, 1, 3, 5}});
  Mesh mesh;
  std::unordered_map<Mesh::Vertex_index, std::size_t> origin;
  EXPECT_THROW_WITH(CP::extract_boundary(bad, mesh, boost::make_assoc_property_map(origin)),
                    std::invalid_argument, "share a face");
  bad = box;
  bad.cells.push_back({{box.cells[2][1], box.cells[2][0], box.cells[2][3], box.cells[2][2]}});
  Mesh other;
  EXPECT_THROW_WITH(CP::extract_boundary(bad, other, boost::make_assoc_property_map(origin)),
                    std::invalid_argument,
                    "cells 2 and " + std::to_string(box.cells.size()) + " are the same");
  EXPECT_THROW_WITH(CP::complex_body(Tetrahedra()), std::invalid_argument, "no cell");
}

} // namespace test_tetrahedral_complex
