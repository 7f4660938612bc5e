// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"

#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <limits>

namespace test_wavefront_geodesics_input {

using namespace Canonical_pose_test;
using Wavefront = CGAL::Canonical_pose_3::Wavefront_geodesics_3<Mesh>;

const double INF = std::numeric_limits<double>::infinity();

std::string refusal(const Mesh& mesh)
{
  return message_of<std::invalid_argument>([&] { Wavefront wavefront(mesh); });
}

TEST(Wavefront_geodesics_input, coordinates_that_are_not_finite)
{
  for(double bad : {INF, -INF, std::numeric_limits<double>::quiet_NaN()})
  {
    Mesh mesh = icosphere<Mesh>(1, 1.);
    mesh.point(vertex(mesh, 5)) = Kernel::Point_3(0., bad, 0.);
    EXPECT_EQ(refusal(mesh), "vertex 5 has a coordinate that is not finite");
  }
}

TEST(Wavefront_geodesics_input, nothing_to_measure)
{
  Mesh mesh;
  EXPECT_EQ(refusal(mesh), "the mesh is empty: it has no face");
  mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  EXPECT_EQ(refusal(mesh), "the mesh is empty: it has no face");
  EXPECT_EQ(refusal(to_mesh<Mesh>({{{0, 0, 0}}, {{1, 1, 1}}, {{3, 3, 3}}}, {{{0, 1, 2}}})),
            "face 0 is degenerate, and so are all the others");
  EXPECT_EQ(refusal(to_mesh<Mesh>({{{7, 7, 7}}, {{7, 7, 7}}, {{7, 7, 7}}}, {{{0, 1, 2}}})),
            "face 0 is degenerate, and so are all the others");
}

TEST(Wavefront_geodesics_input, faces_that_are_not_triangles)
{
  Mesh mesh = plane_grid<Mesh>(3, 1, 3., 1.);
  const auto a = mesh.add_vertex(Kernel::Point_3(4, 0, 0)),
             b = mesh.add_vertex(Kernel::Point_3(4, 1, 0));
  mesh.add_face(vertex(mesh, 3), a, b, vertex(mesh, 7));
  EXPECT_EQ(refusal(mesh), "face 6 is not a triangle");
}

TEST(Wavefront_geodesics_input, null_vertex)
{
  const Mesh mesh = icosphere<Mesh>(0, 1.);
  EXPECT_THROW(Wavefront(mesh).distances(Mesh::null_vertex()), CGAL::Precondition_exception);
}

// One face has two legs of length 1 and no edge to cross.
TEST(Wavefront_geodesics_input, one_triangle)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}});
  const Eigen::VectorXd d = Wavefront(mesh).distances(vertex(mesh, 0));
  EXPECT_EQ(d, Eigen::Vector3d(0., 1., 1.));
}

// Components of sizes 1 and 1e-12, and an isolated vertex: each is independent of the others, and
// infinitely far from them.
TEST(Wavefront_geodesics_input, components)
{
  Triangle_soup soup = icosphere_soup(2, 1.);
  const Mesh mesh_alone = to_mesh<Mesh>(soup);
  const Eigen::VectorXd alone = Wavefront(mesh_alone).distances(Mesh::Vertex_index(0));
  const std::size_t n = soup.points.size();
  soup.points.push_back({{5., 5., 5.}});
  for(std::size_t i = 0; i < n; ++i)
    soup.points.push_back(
      {{1e-12 * soup.points[i][0], 1e-12 * soup.points[i][1], 1e-12 * soup.points[i][2]}});
  for(std::size_t f = 0, faces = soup.triangles.size(); f < faces; ++f)
  {
    const auto t = soup.triangles[f];
    soup.triangles.push_back({{t[0] + n + 1, t[1] + n + 1, t[2] + n + 1}});
  }
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Wavefront wavefront(mesh);
  const auto rows = static_cast<Eigen::Index>(n);
  const Eigen::VectorXd large = wavefront.distances(vertex(mesh, 0)),
                        lonely = wavefront.distances(vertex(mesh, n)),
                        small = wavefront.distances(vertex(mesh, n + 1));
  EXPECT_LT((large.head(rows) - alone).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((small.tail(rows) * 1e12 - alone).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE((large.tail(rows + 1).array() == INF).all());
  EXPECT_TRUE((small.head(rows + 1).array() == INF).all());
  EXPECT_EQ(lonely[rows], 0.);
  EXPECT_TRUE((lonely.head(rows).array() == INF).all() && (lonely.tail(rows).array() == INF).all());
}

// A vertex at the midpoint of an edge of a grid creates a face without area; a coincident vertex
// creates several. The distances to the other vertices do not change.
TEST(Wavefront_geodesics_input, degenerate_faces)
{
  Mesh mesh = plane_grid<Mesh>(20, 20, 20., 20.);
  const Eigen::VectorXd before = Wavefront(mesh).distances(vertex(mesh, 0));
  const auto h = mesh.halfedge(vertex(mesh, 100), vertex(mesh, 101));
  const auto middle = CGAL::Euler::add_center_vertex(h, mesh);
  mesh.point(mesh.target(middle))
    = CGAL::midpoint(mesh.point(vertex(mesh, 100)), mesh.point(vertex(mesh, 101)));
  const auto corner
    = CGAL::Euler::add_center_vertex(mesh.halfedge(vertex(mesh, 300), vertex(mesh, 301)), mesh);
  mesh.point(mesh.target(corner)) = mesh.point(vertex(mesh, 300));
  const Eigen::VectorXd after = Wavefront(mesh).distances(vertex(mesh, 0));
  ASSERT_EQ(after.size(), before.size() + 2);
  EXPECT_TRUE(after.allFinite());
  EXPECT_LT((after.head(before.size()) - before).cwiseAbs().maxCoeff(), 1e-6 * before.maxCoeff());
  EXPECT_NEAR(after[before.size() + 1], after[300], 1e-6);
}

TEST(Wavefront_geodesics_input, landmarks_by_fronts_on_own_points)
{
  using CGAL::Canonical_pose_3::Wavefront_geodesics_3;
  expect_fronts_on_own_points<Wavefront_geodesics_3<Mesh>,
                              Wavefront_geodesics_3<Mesh, Mesh_with_points::Point_map>>();
}

} // namespace test_wavefront_geodesics_input
