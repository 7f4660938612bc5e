// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace test_distances_input {

using namespace Canonical_pose_test;
namespace CP = CGAL::Canonical_pose_3;

const double INF = std::numeric_limits<double>::infinity();

// A class template of distances, and what its algorithm makes of faces without area: they change distances by a
// fraction of the largest one, or are refused.
template <template <class...> class Class, int per_million>
struct Kind
{
  template <class... Parameters>
  using Distances_of = Class<Mesh, Parameters...>;
  using Distances = Class<Mesh>;

  static constexpr bool refuses_degenerate_faces = per_million < 0;
  static constexpr double change = per_million * 1e-6;
};

template <class T>
class Distances_input : public testing::Test
{
protected:
  using Distances = typename T::Distances;

  static std::string refusal(const Mesh& mesh)
  {
    return message_of<std::invalid_argument>([&] { Distances distances(mesh); });
  }
};

using Kinds = testing::Types<Kind<CP::Heat_geodesics_3, 10000>, Kind<CP::Wavefront_geodesics_3, 1>,
                             Kind<CP::Exact_geodesics_3, -1>>;
TYPED_TEST_SUITE(Distances_input, Kinds);

TYPED_TEST(Distances_input, coordinates_that_are_not_finite)
{
  for(double bad : {INF, -INF, std::numeric_limits<double>::quiet_NaN()})
  {
    Mesh mesh = icosphere<Mesh>(1, 1.);
    mesh.point(vertex(mesh, 5)) = Kernel::Point_3(0., bad, 0.);
    EXPECT_EQ(this->refusal(mesh), "vertex 5 has a coordinate that is not finite");
  }
}

TYPED_TEST(Distances_input, nothing_to_measure)
{
  const std::string degenerate = TypeParam::refuses_degenerate_faces
                                   ? "face 0 is degenerate"
                                   : "face 0 is degenerate, and so are all the others";
  Mesh mesh;
  EXPECT_EQ(this->refusal(mesh), "the mesh is empty: it has no face");
  mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  EXPECT_EQ(this->refusal(mesh), "the mesh is empty: it has no face");
  EXPECT_EQ(this->refusal(to_mesh<Mesh>({{{0, 0, 0}}, {{1, 1, 1}}, {{3, 3, 3}}}, {{{0, 1, 2}}})),
            degenerate);
  EXPECT_EQ(this->refusal(to_mesh<Mesh>({{{7, 7, 7}}, {{7, 7, 7}}, {{7, 7, 7}}}, {{{0, 1, 2}}})),
            degenerate);
}

TYPED_TEST(Distances_input, faces_that_are_not_triangles)
{
  Mesh mesh = plane_grid<Mesh>(3, 1, 3., 1.);
  const auto a = mesh.add_vertex(Kernel::Point_3(4, 0, 0)),
             b = mesh.add_vertex(Kernel::Point_3(4, 1, 0));
  mesh.add_face(vertex(mesh, 3), a, b, vertex(mesh, 7));
  EXPECT_EQ(this->refusal(mesh), "face 6 is not a triangle");
}

TYPED_TEST(Distances_input, null_vertex)
{
  const Mesh mesh = icosphere<Mesh>(0, 1.);
  EXPECT_THROW(typename TypeParam::Distances(mesh).distances(Mesh::null_vertex()),
               CGAL::Precondition_exception);
}

// Components of sizes 1 and 1e-12, and an isolated vertex: each is independent of the others, and
// infinitely far from them.
TYPED_TEST(Distances_input, components)
{
  Triangle_soup soup = icosphere_soup(2, 1.);
  const Mesh mesh_alone = to_mesh<Mesh>(soup);
  const Eigen::VectorXd alone =
    typename TypeParam::Distances(mesh_alone).distances(Mesh::Vertex_index(0));
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
  const typename TypeParam::Distances distances(mesh);
  const auto rows = static_cast<Eigen::Index>(n);
  const Eigen::VectorXd large = distances.distances(vertex(mesh, 0)),
                        lonely = distances.distances(vertex(mesh, n)),
                        small = distances.distances(vertex(mesh, n + 1));
  EXPECT_LT((large.head(rows) - alone).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((small.tail(rows) * 1e12 - alone).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE((large.tail(rows + 1).array() == INF).all());
  EXPECT_TRUE((small.head(rows + 1).array() == INF).all());
  EXPECT_EQ(lonely[rows], 0.);
  EXPECT_TRUE((lonely.head(rows).array() == INF).all() && (lonely.tail(rows).array() == INF).all());
}

// A vertex at the midpoint of an edge of a grid creates a face without area; a coincident vertex
// creates several. The distances to the other vertices do not change, up to the error of the distances.
TYPED_TEST(Distances_input, degenerate_faces)
{
  Mesh mesh = plane_grid<Mesh>(20, 20, 20., 20.);
  const Eigen::VectorXd before = typename TypeParam::Distances(mesh).distances(vertex(mesh, 0));
  const auto h = mesh.halfedge(vertex(mesh, 100), vertex(mesh, 101));
  const auto middle = CGAL::Euler::add_center_vertex(h, mesh);
  mesh.point(mesh.target(middle))
    = CGAL::midpoint(mesh.point(vertex(mesh, 100)), mesh.point(vertex(mesh, 101)));
  const auto corner
    = CGAL::Euler::add_center_vertex(mesh.halfedge(vertex(mesh, 300), vertex(mesh, 301)), mesh);
  mesh.point(mesh.target(corner)) = mesh.point(vertex(mesh, 300));
  if(TypeParam::refuses_degenerate_faces)
  {
    EXPECT_NE(this->refusal(mesh).find("is degenerate"), std::string::npos);
    return;
  }
  const Eigen::VectorXd after = typename TypeParam::Distances(mesh).distances(vertex(mesh, 0));
  ASSERT_EQ(after.size(), before.size() + 2);
  EXPECT_TRUE(after.allFinite());
  EXPECT_LT((after.head(before.size()) - before).cwiseAbs().maxCoeff(),
            TypeParam::change * before.maxCoeff());
  EXPECT_NEAR(after[before.size() + 1], after[300], TypeParam::change);
}

// Removed vertices have no row: the bytes are those of a mesh without them.
TYPED_TEST(Distances_input, removed_vertices)
{
  const Mesh sphere = icosphere<Mesh>(2, 1.);
  Mesh clean, mesh;
  const auto garbage = mesh.add_vertex(Kernel::Point_3(NAN, 0, 0));
  CGAL::copy_face_graph(sphere, mesh);
  CGAL::copy_face_graph(sphere, clean);
  mesh.remove_vertex(garbage);
  ASSERT_TRUE(mesh.has_garbage());
  const typename TypeParam::Distances distances(mesh);
  EXPECT_EQ(distances.index(Mesh::Vertex_index(162)), 161u);
  EXPECT_EQ(distances.distances(*vertices(mesh).begin()),
            typename TypeParam::Distances(clean).distances(*vertices(clean).begin()));
}

// A point type without public members, a user-defined map, and the overload that writes to a
// property map.
TYPED_TEST(Distances_input, own_points_and_maps)
{
  using Map = std::map<Mesh::Vertex_index, archetype::Point>;
  using Point_map = boost::const_associative_property_map<Map>;
  const Mesh mesh = icosphere<Mesh>(2, 1.);
  Map points;
  for(auto v : mesh.vertices())
    points.emplace(v, CGAL::Canonical_pose_3::internal::from_row(
                        archetype::Traits(),
                        Eigen::Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z())));
  const typename TypeParam::template Distances_of<Point_map, archetype::Traits> distances(
    mesh, Point_map(points));
  const Eigen::VectorXd d = typename TypeParam::Distances(mesh).distances(vertex(mesh, 3));
  EXPECT_EQ(distances.distances(vertex(mesh, 3)), d);
  std::map<Mesh::Vertex_index, float> written;
  distances.distances(vertex(mesh, 3), boost::make_assoc_property_map(written));
  for(auto v : mesh.vertices())
    EXPECT_EQ(written[v], static_cast<float>(d[static_cast<Eigen::Index>(distances.index(v))]));
  EXPECT_EQ(&distances.triangle_mesh(), &mesh);
}

TYPED_TEST(Distances_input, landmarks_by_fronts_on_own_points)
{
  expect_fronts_on_own_points<
    typename TypeParam::Distances,
    typename TypeParam::template Distances_of<Mesh_with_points::Point_map>>();
}

} // namespace test_distances_input
