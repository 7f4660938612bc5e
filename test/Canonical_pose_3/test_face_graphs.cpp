// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Face graphs that are not CGAL's. Everything runs on the same arrays for any mesh type: equal
// vertices and faces in the same order yield the same bytes, in every function that takes a face
// graph.

#include "Triangle_graph.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>
#include <CGAL/Surface_mesh.h>

#ifdef CANONICAL_POSE_3_TEST_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <cstddef>
#include <map>
#include <vector>

namespace test_face_graphs {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::to_mesh;
using CP::Point_matrix;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Canonical_pose_test::Triangle_soup bent_bar()
{
  return Canonical_pose_test::boundary(Canonical_pose_test::tetrahedral_bent_bar(16, 2, 2, 2.5));
}

Point_matrix pose_of(const Canonical_pose_test::Triangle_soup& soup)
{
  Mesh mesh = to_mesh<Mesh>(soup);
  EXPECT_TRUE(CGAL::canonical_pose_3(mesh, mesh.points()).summary.converged());
  return CP::point_matrix(mesh);
}

Eigen::MatrixXd some_distances(const Canonical_pose_test::Triangle_soup& soup)
{
  return Canonical_pose_test::to_matrix(soup.points).rowwise().norm();
}

template <class Geodesics, class Any_mesh>
CP::Landmark_fields_3 landmarks(const Any_mesh& mesh)
{
  const Geodesics geodesics(mesh);
  const CP::Landmark_fields_3 fields
    = CP::front_landmarks(geodesics, 20, *std::next(vertices(mesh).begin(), 7));
  EXPECT_EQ(geodesics.index(*std::next(vertices(mesh).begin(), 7)), 7u);
  EXPECT_EQ(geodesics.distances(*std::next(vertices(mesh).begin(), 7)), fields.distances.col(0));
  return fields;
}

template <template <class...> class Geodesics, class Any_mesh>
void expect_equal_landmarks(const Any_mesh& mesh, const Canonical_pose_test::Triangle_soup& soup)
{
  const auto expected = landmarks<Geodesics<Mesh>>(to_mesh<Mesh>(soup));
  const auto fields = landmarks<Geodesics<Any_mesh>>(mesh);
  EXPECT_EQ(fields.landmarks, expected.landmarks);
  EXPECT_EQ(fields.distances, expected.distances);
  EXPECT_EQ(fields.covering_radius, expected.covering_radius);
}

// CGAL's concept requires hashable descriptors. Here they have std::hash but no dynamic property,
// or vice versa: either suffices.
template <class Graph>
class Archetypes_of_graphs : public testing::Test
{};

using Archetypes = testing::Types<archetype::Hashed_graph, archetype::Graph_with_properties>;
TYPED_TEST_SUITE(Archetypes_of_graphs, Archetypes);

TYPED_TEST(Archetypes_of_graphs, give_the_same_bytes)
{
  const auto soup = bent_bar();
  const TypeParam graph(soup);
  const CP::Lattice_body_3 body(graph, graph.points, some_distances(soup));
  EXPECT_EQ(body.points(), CP::Lattice_body_3(to_mesh<Mesh>(soup), to_mesh<Mesh>(soup).points(),
                                              some_distances(soup))
                             .points());
  CGAL::canonical_pose_3(graph, graph.points);
  EXPECT_EQ(CP::point_matrix(graph, graph.points), pose_of(soup));
}

// Also an open one, whose border has halfedges of no face.
TYPED_TEST(Archetypes_of_graphs, have_the_same_distances)
{
  for(const auto& soup : {bent_bar(), Canonical_pose_test::plane_grid_soup(9, 5, 3., 1.)})
  {
    expect_equal_landmarks<CP::Heat_geodesics_3>(TypeParam(soup), soup);
    expect_equal_landmarks<CP::Wavefront_geodesics_3>(TypeParam(soup), soup);
  }
}

// Functions that take a mesh and named parameters.
TYPED_TEST(Archetypes_of_graphs, have_the_same_measures)
{
  const auto soup = bent_bar();
  const TypeParam graph(soup);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const auto map = CGAL::parameters::vertex_point_map(graph.points).geom_traits(Kernel());
  EXPECT_EQ(CP::diagnose(graph).faces, soup.triangles.size());
  EXPECT_TRUE(CP::diagnose(graph, map).is_clean());
  EXPECT_EQ(CP::vertex_area_shares(graph), CP::vertex_area_shares(mesh));
  EXPECT_EQ(CP::vertex_area_shares(graph, map), CP::vertex_area_shares(mesh, mesh.points()));
  EXPECT_EQ(CP::extremal_vertex(graph, map).index, std::size_t(CP::extremal_vertex(mesh)));
  const Point_matrix target = Canonical_pose_test::to_matrix(soup.points);
  EXPECT_EQ(CP::target_handedness(target, graph, map).volume_ratio,
            CP::target_handedness(target, mesh).volume_ratio);
  const Eigen::MatrixXd distances = some_distances(soup);
  const CP::Lattice_body_3 expected(mesh, mesh.points(), distances);
  EXPECT_EQ(CP::Lattice_body_3(graph, distances).points(), expected.points());
  EXPECT_EQ(CP::Lattice_body_3(graph, distances, map).points(), expected.points());
  EXPECT_EQ(CP::Lattice_body_3(graph, distances, 0., map).points(), expected.points());
}

#ifdef CANONICAL_POSE_3_TEST_OPENMESH

struct Double_points : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
using Open_mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_points>;

// The same mesh, except for a removed vertex that still has index 0.
Open_mesh open_mesh(const Canonical_pose_test::Triangle_soup& soup)
{
  Open_mesh mesh;
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.delete_vertex(mesh.add_vertex({9, 9, 9}));
  std::vector<Open_mesh::VertexHandle> handles;
  for(const auto& p : soup.points)
    handles.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for(const auto& t : soup.triangles)
    mesh.add_face(handles[t[0]], handles[t[1]], handles[t[2]]);
  return mesh;
}

TEST(Open_mesh, has_the_same_landmarks_and_distances)
{
  expect_equal_landmarks<CP::Heat_geodesics_3>(open_mesh(bent_bar()), bent_bar());
  expect_equal_landmarks<CP::Wavefront_geodesics_3>(open_mesh(bent_bar()), bent_bar());
}

TEST(Open_mesh, lies_in_the_same_lattice)
{
  const auto soup = bent_bar();
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Open_mesh other = open_mesh(soup);
  const CP::Lattice_body_3 expected(mesh, mesh.points(), some_distances(soup));
  const CP::Lattice_body_3 body(other, get(CGAL::vertex_point, other), some_distances(soup));
  EXPECT_EQ(body.points(), expected.points());
  EXPECT_EQ(body.cells(), expected.cells());
  EXPECT_EQ(Eigen::MatrixXd(body.embedding()), Eigen::MatrixXd(expected.embedding()));
}

// In a separate map: put() of CGAL's adaptor rounds to single precision.
TEST(Open_mesh, has_the_same_pose)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const Open_mesh mesh = open_mesh(bent_bar());
  std::map<Open_mesh::VertexHandle, Point> pose;
  CGAL::canonical_pose_3(mesh, boost::make_assoc_property_map(pose));
  EXPECT_EQ(pose.size(), bent_bar().points.size());
  EXPECT_EQ(CP::point_matrix(mesh, boost::make_assoc_property_map(pose)), pose_of(bent_bar()));
}
#endif

} // namespace test_face_graphs
