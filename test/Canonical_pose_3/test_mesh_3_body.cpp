// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/mesh_3_body.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "matchers.h"
#include "shapes.h"

namespace test_mesh_3_body {

namespace CP = CGAL::Canonical_pose_3;
namespace PMP = CGAL::Polygon_mesh_processing;
using Canonical_pose_test::pi;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

std::size_t number_of_components(const CP::Embedded_body_3& body)
{
  const std::size_t n = std::size_t(body.points().rows());
  CP::internal::Disjoint_sets sets(n);
  for(const auto& cell : body.cells())
    for(const int v : cell)
      sets.unite(std::size_t(cell[0]), std::size_t(v));
  std::size_t result = 0;
  for(std::size_t v = 0; v < n; ++v)
    result += sets.representative(v) == v;
  return result;
}

void expect_hangs(const CP::Embedded_body_3& body, const CP::Point_matrix& points,
                  const double length_scale)
{
  EXPECT_LT((body.embedding() * body.points() - points).cwiseAbs().maxCoeff(),
            1e-12 * length_scale);
  EXPECT_LT(body.embedding().coeffs().abs().maxCoeff(), 8);
  EXPECT_NEAR(body.cell_weights().sum(), 1, 1e-12);
  EXPECT_GT(body.cell_weights().minCoeff(), 0);
  EXPECT_EQ(number_of_components(body), 1u);
}

// Rest positions are reproduced exactly for any cells; the volume is that of the surface up to the
// permitted distance, a tenth of the cell size; at other scales, powers of two here, the bytes are
// the same.
TEST(Mesh_3_body, hangs_the_surface_in_cells)
{
  const Mesh mesh = Canonical_pose_test::torus<Mesh>(48, 24, 1., 0.4);
  const CP::Point_matrix points = CP::point_matrix(mesh);
  const double length_scale = 1.5 * pi;
  const CP::Embedded_body_3 body = CP::mesh_3_body(mesh, mesh.points(), length_scale, 1. / 30);
  expect_hangs(body, points, length_scale);
  EXPECT_NEAR(body.volume() / PMP::volume(mesh), 1, 0.03);
  EXPECT_EQ(body.embedding().rows(), points.rows());

  const auto triangles = CP::internal::index_triangles(mesh);
  for(const double unit : {1., 0x1p-400, 0x1p+300})
  {
    const CP::Point_matrix scaled = unit * points;
    const auto other = CP::mesh_3_body(scaled, triangles, unit * length_scale, 1. / 30);
    EXPECT_EQ(other.cells(), body.cells());
    EXPECT_TRUE(other.points() == unit * body.points());
    EXPECT_TRUE(Eigen::MatrixXd(other.embedding()) == Eigen::MatrixXd(body.embedding()));
  }
}

// A wire thinner than the cells, bent so that its middle is far from the center of the shape.
TEST(Mesh_3_body, keeps_thin_parts)
{
  const Mesh mesh = Canonical_pose_test::tube<Mesh>(200, 12, 10., 0.1, 1.5 * pi);
  const CP::Embedded_body_3 body = CP::mesh_3_body(mesh, mesh.points(), 10., 1. / 50);
  expect_hangs(body, CP::point_matrix(mesh), 10);
  EXPECT_NEAR(body.volume() / PMP::volume(mesh), 1, 0.2);
}

// Few vertices are not a sufficient start for Mesh_3: the faces of a tetrahedron are sampled.
TEST(Mesh_3_body, takes_large_faces)
{
  const Mesh mesh
    = Canonical_pose_test::to_mesh<Mesh>({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}},
                                         {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}});
  const CP::Embedded_body_3 body = CP::mesh_3_body(mesh, mesh.points(), 2.);
  expect_hangs(body, CP::point_matrix(mesh), 2);
  EXPECT_NEAR(body.volume(), 1. / 6, 0.001);

  // the same, with named parameters: the points are those of another mesh
  Mesh moved = mesh;
  for(const auto v : moved.vertices())
    moved.point(v) = CGAL::ORIGIN;
  const auto np = CGAL::parameters::vertex_point_map(mesh.points()).geom_traits(Mesh::Point::R());
  const CP::Embedded_body_3 same = CP::mesh_3_body(moved, 2., CP::internal::MESH_3_CELL_SIZE, np);
  EXPECT_EQ(same.points(), body.points());
  EXPECT_EQ(same.cells(), body.cells());
}

TEST(Mesh_3_body, refuses_by_name)
{
  Mesh mesh = Canonical_pose_test::tube<Mesh>(100, 12, 10., 0.01);
  EXPECT_THROW_WITH(CP::mesh_3_body(mesh, mesh.points(), 10., 1. / 20), std::runtime_error, "thin");
  EXPECT_THROW_WITH(CP::mesh_3_body(mesh, mesh.points(), 10., 1e-5), std::invalid_argument,
                    "a thousandth");
  EXPECT_THROW_WITH(CP::mesh_3_body(mesh, mesh.points(), NAN), std::invalid_argument,
                    "length_scale is nan");
  mesh = Canonical_pose_test::torus<Mesh>(24, 12, 1., 0.4);
  mesh.point(Mesh::Vertex_index(0)) = Mesh::Point(-3, 0, 0);
  EXPECT_THROW_WITH(CP::mesh_3_body(mesh, mesh.points(), 5.), std::invalid_argument,
                    "intersects itself");
}

// Checks of the class itself.
TEST(Embedded_body, checks_the_embedding)
{
  CP::Point_matrix points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  Eigen::SparseMatrix<double> embedding(2, 4);
  embedding.insert(0, 0) = 1;
  embedding.insert(1, 1) = 3;
  embedding.insert(1, 2) = -2;
  const CP::Embedded_body_3 body(points, {{{0, 1, 2, 3}}}, embedding);
  EXPECT_DOUBLE_EQ(body.volume(), 1. / 6);
  embedding.coeffRef(1, 2) = -1;
  EXPECT_THROW_WITH(CP::Embedded_body_3(points, {{{0, 1, 2, 3}}}, embedding), std::invalid_argument,
                    "row 1 of the embedding");
  EXPECT_THROW_WITH(
    CP::Embedded_body_3(points, {{{0, 1, 2, 3}}}, Eigen::SparseMatrix<double>(2, 3)),
    std::invalid_argument, "3 columns");
}

} // namespace test_mesh_3_body
