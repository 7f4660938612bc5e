// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace test_heat_geodesics_input {

using namespace Canonical_pose_test;
using Heat = CGAL::Canonical_pose_3::Heat_geodesics_3<Mesh>;

const double INF = std::numeric_limits<double>::infinity();

std::string refusal(const Mesh& mesh)
{
  return message_of<std::invalid_argument>([&] { Heat heat(mesh); });
}

TEST(Heat_geodesics_input, coordinates_that_are_not_finite)
{
  for(double bad : {INF, -INF, std::numeric_limits<double>::quiet_NaN()})
  {
    Mesh mesh = icosphere<Mesh>(1, 1.);
    mesh.point(vertex(mesh, 5)) = Kernel::Point_3(0., bad, 0.);
    EXPECT_EQ(refusal(mesh), "vertex 5 has a coordinate that is not finite");
  }
}

TEST(Heat_geodesics_input, nothing_to_measure)
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

TEST(Heat_geodesics_input, faces_that_are_not_triangles)
{
  Mesh mesh = plane_grid<Mesh>(3, 1, 3., 1.);
  const auto a = mesh.add_vertex(Kernel::Point_3(4, 0, 0)),
             b = mesh.add_vertex(Kernel::Point_3(4, 1, 0));
  mesh.add_face(vertex(mesh, 3), a, b, vertex(mesh, 7));
  EXPECT_EQ(refusal(mesh), "face 6 is not a triangle");
}

TEST(Heat_geodesics_input, null_vertex)
{
  const Mesh mesh = icosphere<Mesh>(0, 1.);
  EXPECT_THROW(Heat(mesh).distances(Mesh::null_vertex()), CGAL::Precondition_exception);
}

TEST(Heat_geodesics_input, time_step_factors_out_of_bounds)
{
  const Mesh mesh = icosphere<Mesh>(1, 1.);
  const auto said = [&](double factor) {
    return message_of<std::invalid_argument>([&] { Heat(mesh, mesh.points(), Kernel(), factor); });
  };
  for(double factor : {0., -1., -INF, INF, std::numeric_limits<double>::quiet_NaN(), 1.1e6})
  {
    EXPECT_NE(said(factor).find("the time step factor is "), std::string::npos) << factor;
    EXPECT_EQ(message_of<std::invalid_argument>([&] { Heat(mesh, factor); }), said(factor));
  }
  EXPECT_EQ(said(-1.), "the time step factor is -1, not positive and at most 1e6");
  for(double factor : {std::numeric_limits<double>::denorm_min(), 1e6})
    EXPECT_EQ(said(factor), "nothing");
}

// On a right triangle with legs 1 there is one face, no inner edge, and the gradient of the heat is
// constant: the distance is a linear function that is 0 at the source and equal at the two others,
// hence 1/sqrt(2).
TEST(Heat_geodesics_input, one_triangle)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}});
  const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, 0));
  EXPECT_EQ(d[0], 0.);
  EXPECT_NEAR(d[1], std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(d[2], std::sqrt(0.5), 1e-14);
}

// Components of sizes 1 and 1e-12, and an isolated vertex: each is independent of the others, and
// infinitely far from them.
TEST(Heat_geodesics_input, components)
{
  Triangle_soup soup = icosphere_soup(2, 1.);
  const Mesh mesh_alone = to_mesh<Mesh>(soup);
  const Eigen::VectorXd alone = Heat(mesh_alone).distances(Mesh::Vertex_index(0));
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
  const Heat heat(mesh);
  const auto rows = static_cast<Eigen::Index>(n);
  const Eigen::VectorXd large = heat.distances(vertex(mesh, 0)),
                        lonely = heat.distances(vertex(mesh, n)),
                        small = heat.distances(vertex(mesh, n + 1));
  EXPECT_LT((large.head(rows) - alone).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((small.tail(rows) * 1e12 - alone).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE((large.tail(rows + 1).array() == INF).all());
  EXPECT_TRUE((small.head(rows + 1).array() == INF).all());
  EXPECT_EQ(lonely[rows], 0.);
  EXPECT_TRUE((lonely.head(rows).array() == INF).all() && (lonely.tail(rows).array() == INF).all());
}

// A vertex at the midpoint of an edge of a grid creates a face without area; a coincident vertex
// creates several. The distances to the other vertices do not change.
TEST(Heat_geodesics_input, degenerate_faces)
{
  Mesh mesh = plane_grid<Mesh>(20, 20, 20., 20.);
  const Eigen::VectorXd before = Heat(mesh).distances(vertex(mesh, 0));
  const auto h = mesh.halfedge(vertex(mesh, 100), vertex(mesh, 101));
  const auto middle = CGAL::Euler::add_center_vertex(h, mesh);
  mesh.point(mesh.target(middle))
    = CGAL::midpoint(mesh.point(vertex(mesh, 100)), mesh.point(vertex(mesh, 101)));
  const auto corner
    = CGAL::Euler::add_center_vertex(mesh.halfedge(vertex(mesh, 300), vertex(mesh, 301)), mesh);
  mesh.point(mesh.target(corner)) = mesh.point(vertex(mesh, 300));
  const Eigen::VectorXd after = Heat(mesh).distances(vertex(mesh, 0));
  ASSERT_EQ(after.size(), before.size() + 2);
  EXPECT_TRUE(after.allFinite());
  EXPECT_LT((after.head(before.size()) - before).cwiseAbs().maxCoeff(), 0.01 * before.maxCoeff());
  EXPECT_NEAR(after[before.size() + 1], after[300], 0.01);
}

// Removed vertices have no row: the bytes are those of a mesh without them.
TEST(Heat_geodesics_input, removed_vertices)
{
  const Mesh sphere = icosphere<Mesh>(2, 1.);
  Mesh clean, mesh;
  const auto garbage = mesh.add_vertex(Kernel::Point_3(NAN, 0, 0));
  CGAL::copy_face_graph(sphere, mesh);
  CGAL::copy_face_graph(sphere, clean);
  mesh.remove_vertex(garbage);
  ASSERT_TRUE(mesh.has_garbage());
  const Heat heat(mesh);
  EXPECT_EQ(heat.index(Mesh::Vertex_index(162)), 161u);
  EXPECT_EQ(heat.distances(*vertices(mesh).begin()),
            Heat(clean).distances(*vertices(clean).begin()));
}

// A point type without public members, a user-defined map, and the overload that writes to a
// property map.
TEST(Heat_geodesics_input, own_points_and_maps)
{
  using Map = std::map<Mesh::Vertex_index, archetype::Point>;
  using Point_map = boost::const_associative_property_map<Map>;
  const Mesh mesh = icosphere<Mesh>(2, 1.);
  Map points;
  for(auto v : mesh.vertices())
    points.emplace(v, CGAL::Canonical_pose_3::internal::from_row(
                        archetype::Traits(),
                        Eigen::Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z())));
  const CGAL::Canonical_pose_3::Heat_geodesics_3<Mesh, Point_map, archetype::Traits> heat(
    mesh, Point_map(points));
  const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, 3));
  EXPECT_EQ(heat.distances(vertex(mesh, 3)), d);
  std::map<Mesh::Vertex_index, float> written;
  heat.distances(vertex(mesh, 3), boost::make_assoc_property_map(written));
  for(auto v : mesh.vertices())
    EXPECT_EQ(written[v], static_cast<float>(d[static_cast<Eigen::Index>(heat.index(v))]));
  EXPECT_EQ(&heat.triangle_mesh(), &mesh);
}

TEST(Heat_geodesics_input, landmarks_by_fronts_on_own_points)
{
  using CGAL::Canonical_pose_3::Heat_geodesics_3;
  expect_fronts_on_own_points<Heat_geodesics_3<Mesh>,
                              Heat_geodesics_3<Mesh, Mesh_with_points::Point_map>>();
}

} // namespace test_heat_geodesics_input
