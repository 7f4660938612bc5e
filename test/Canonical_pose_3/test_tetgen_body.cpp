// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/tetgen_body.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

namespace test_tetgen_body {

namespace CP = CGAL::Canonical_pose_3;
namespace PMP = CGAL::Polygon_mesh_processing;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// TetGen keeps the vertices, and its cells fill the volume of the surface: a polyhedron, hence
// exactly.
TEST(Tetgen_body, fills_the_surface)
{
  Mesh mesh = Canonical_pose_test::torus<Mesh>(24, 12, 1., 0.4);
  const CP::Conforming_body_3 body = CP::tetgen_body(mesh, mesh.points());
  EXPECT_NEAR(body.volume(), PMP::volume(mesh), 1e-12);
  ASSERT_GE(body.points().rows(), Eigen::Index(mesh.number_of_vertices()));
  for(const auto v : mesh.vertices())
    EXPECT_EQ(body.points()(Eigen::Index(v), 0), mesh.point(v).x());
  EXPECT_EQ(body.embedding().rows(), Eigen::Index(mesh.number_of_vertices()));
  EXPECT_EQ(CP::tetgen_body(mesh).points(), body.points());

  // also in other units
  for(const double unit : {1e-6, 1e6, 1e-90})
  {
    Mesh scaled = mesh;
    for(const auto v : scaled.vertices())
      scaled.point(v) = CGAL::ORIGIN + unit * (mesh.point(v) - CGAL::ORIGIN);
    const double volume = CP::tetgen_body(scaled, scaled.points()).volume();
    EXPECT_NEAR(volume / (unit * unit * unit), body.volume(), 1e-11);
    const auto np
      = CGAL::parameters::vertex_point_map(scaled.points()).geom_traits(Mesh::Point::R());
    EXPECT_EQ(CP::tetgen_body(mesh, np).volume(), volume);
  }
}

// TetGen would terminate the process on this surface: two faces moved through the opposite side.
TEST(Tetgen_body, refuses_what_tetgen_dies_of)
{
  Mesh mesh = Canonical_pose_test::torus<Mesh>(24, 12, 1., 0.4);
  mesh.point(Mesh::Vertex_index(0))
    = CGAL::ORIGIN - 3 * (mesh.point(Mesh::Vertex_index(0)) - CGAL::ORIGIN);
  EXPECT_THROW_WITH(CP::tetgen_body(mesh, mesh.points()), std::invalid_argument,
                    "intersects itself");
}

} // namespace test_tetgen_body
