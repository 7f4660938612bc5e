// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <vector>

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

// Exact: directions, as of the surface. Vertices in the interior have weights, too.
TEST(Tetgen_body, stance_of_the_complex)
{
  using Canonical_pose_examples::Articulated_figure;
  using Canonical_pose_examples::Landmark;
  using Point_3 = Mesh::Point;
  const Articulated_figure figure(2000);
  const CP::Conforming_body_3 body = CP::tetgen_body(figure.make_mesh<Mesh>());
  CP::Indexed_tetrahedra_3<Point_3> complex;
  for(Eigen::Index v = 0; v < body.points().rows(); ++v)
    complex.points.emplace_back(body.points()(v, 0), body.points()(v, 1), body.points()(v, 2));
  for(const auto& cell : body.cells())
  {
    auto& indices = complex.cells.emplace_back();
    std::copy(cell.begin(), cell.end(), indices.begin());
  }
  CP::Options options;
  options.stance = CP::Options::Stance::T;
  std::vector<Point_3> pose = complex.points;
  const CP::Result result = CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), options);
  ASSERT_TRUE(result.is_usable());
  EXPECT_EQ(result.summary.inverted, 0u);
  const auto hand = static_cast<Eigen::Index>(figure.landmark(Landmark::LEFT_HAND));
  const double size = result.pose.col(1).maxCoeff();
  EXPECT_GT(result.pose(hand, 0), result.pose.col(0).maxCoeff() - .1 * size);
  ASSERT_EQ(result.skeleton->weights.rows(), result.pose.rows());
  EXPECT_LT((result.skeleton->weights * Eigen::VectorXd::Ones(result.skeleton->weights.cols())
             - Eigen::VectorXd::Ones(result.pose.rows()))
              .cwiseAbs()
              .maxCoeff(),
            1e-12);
}

} // namespace test_tetgen_body
