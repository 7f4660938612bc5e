// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace test_exact_geodesics {

using namespace Canonical_pose_test;
using Exact = CGAL::Canonical_pose_3::Exact_geodesics_3<Mesh>;

const double INF = std::numeric_limits<double>::infinity();

// In a convex planar region, the shortest path is the straight segment, through triangles of any
// shape.
TEST(Exact_geodesics, plane)
{
  const Triangle_soup soup = stretched_square(12, 7.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Exact exact(mesh);
  for(std::size_t i : {std::size_t(0), std::size_t(80)})
  {
    const Eigen::VectorXd d = exact.distances(vertex(mesh, i)),
                          e = straight_distances(soup.points, i);
    EXPECT_LT((d - e).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(d[static_cast<Eigen::Index>(i)], 0.);
  }
}

// On the unit cube, the opposite corner is at distance sqrt(5), the diagonal of two unfolded faces.
// The diagonal of a face is sqrt(2).
TEST(Exact_geodesics, cube)
{
  Points corners;
  for(int i = 0; i < 8; ++i)
    corners.push_back({{double(i & 1), double((i >> 1) & 1), double(i >> 2)}});
  const Mesh mesh = to_mesh<Mesh>(corners, {{{0, 2, 3}},
                                            {{0, 3, 1}},
                                            {{4, 5, 7}},
                                            {{4, 7, 6}},
                                            {{0, 1, 5}},
                                            {{0, 5, 4}},
                                            {{2, 6, 7}},
                                            {{2, 7, 3}},
                                            {{0, 4, 6}},
                                            {{0, 6, 2}},
                                            {{1, 3, 7}},
                                            {{1, 7, 5}}});
  const Eigen::VectorXd d = Exact(mesh).distances(vertex(mesh, 0));
  for(Eigen::Index i : {1, 2, 4})
    EXPECT_NEAR(d[i], 1., 1e-14);
  for(Eigen::Index i : {3, 5, 6})
    EXPECT_NEAR(d[i], std::sqrt(2.), 1e-14);
  EXPECT_NEAR(d[7], std::sqrt(5.), 1e-14);
}

// Exact distances are a metric. Powers of two scale them bitwise.
TEST(Exact_geodesics, metric_in_any_unit)
{
  const Triangle_soup soup = torus_soup(16, 8, 2., 0.7);
  const auto matrix = [&](double scale) {
    const Mesh mesh = to_mesh<Mesh>(
      transformed(soup.points,
                  [&](std::array<double, 3> p) {
                    return std::array<double, 3>{{scale * p[0], scale * p[1], scale * p[2]}};
                  }),
      soup.triangles);
    return Exact(mesh).distances(mesh.vertices());
  };
  const Eigen::MatrixXd d = matrix(1.);
  EXPECT_LT((d - d.transpose()).cwiseAbs().maxCoeff(), 1e-13 * d.maxCoeff());
  for(Eigen::Index k = 0; k < d.cols(); ++k) // d(i,j) <= d(i,k) + d(k,j)
    EXPECT_LT((d.array() - d.col(k).replicate(1, d.cols()).array()
               - d.row(k).replicate(d.rows(), 1).array())
                .maxCoeff(),
              1e-13 * d.maxCoeff());
  for(int exponent : {-900, 900})
    EXPECT_EQ(matrix(std::ldexp(1., exponent)), d * std::ldexp(1., exponent));
}

// The distance from several sources is the smallest of their distances: on a surface of two
// components, with an isolated vertex among the sources.
TEST(Exact_geodesics, distance_to_nearest)
{
  Mesh mesh = icosphere<Mesh>(2, 1.);
  CGAL::copy_face_graph(torus<Mesh>(16, 8, 2., 0.7), mesh);
  const auto lonely = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  const Exact exact(mesh);
  const std::vector<Mesh::Vertex_index> sources
    = {vertex(mesh, 3), vertex(mesh, 100), lonely, vertex(mesh, 3), vertex(mesh, 160)};
  const Eigen::VectorXd d = exact.distance_to_nearest(sources);
  const Eigen::VectorXd smallest = exact.distances(sources).rowwise().minCoeff();
  EXPECT_LT((d - smallest).head(162).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_TRUE((d.segment(162, 128).array() == INF).all());
  EXPECT_EQ(d[290], 0.);
  EXPECT_EQ(d[3], 0.);
  EXPECT_EQ(exact.distance_to_nearest(std::vector<Mesh::Vertex_index>()).minCoeff(), INF);
}

// The coordinates of all these meshes are the same numbers, which float represents exactly. The
// numbering of the copy depends on the order of the halfedges, and so does rounding.
TEST(Exact_geodesics, any_mesh_kernel_and_map)
{
  Triangle_soup soup = torus_soup(10, 6, 2., 0.7);
  for(auto& p : soup.points)
    for(double& x : p)
      x = static_cast<float>(x);
  const auto distances = [&](const auto& mesh) {
    using Any_mesh = std::decay_t<decltype(mesh)>;
    return CGAL::Canonical_pose_3::Exact_geodesics_3<Any_mesh>(mesh).distances(vertex(mesh, 5));
  };
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::VectorXd d = distances(mesh);
  EXPECT_LT((distances(to_mesh<CGAL::Polyhedron_3<Kernel>>(soup)) - d).cwiseAbs().maxCoeff(),
            1e-13);
  EXPECT_EQ(distances(to_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(soup)),
            d);
  EXPECT_EQ(distances(to_mesh<CGAL::Surface_mesh<CGAL::Epeck::Point_3>>(soup)), d);

  using Map = std::map<Mesh::Vertex_index, archetype::Point>;
  using Point_map = boost::const_associative_property_map<Map>;
  Map points;
  for(auto v : mesh.vertices())
    points.emplace(v, archetype::Traits().construct_point_3_object()(
                        mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  EXPECT_EQ((CGAL::Canonical_pose_3::Exact_geodesics_3<Mesh, Point_map, archetype::Traits>(
               mesh, Point_map(points))
               .distances(vertex(mesh, 5))),
            d);
  std::map<Mesh::Vertex_index, double> written;
  Exact(mesh).distances(vertex(mesh, 5), boost::make_assoc_property_map(written));
  for(auto v : mesh.vertices())
    EXPECT_EQ(written[v], d[static_cast<Eigen::Index>(v.idx())]);
}

// Vertices of other components, and isolated ones, are infinitely far; removed ones have no row.
TEST(Exact_geodesics, components_and_removed_vertices)
{
  Mesh mesh;
  const auto garbage = mesh.add_vertex(Kernel::Point_3(NAN, 0, 0));
  CGAL::copy_face_graph(icosphere<Mesh>(1, 1.), mesh);
  const auto lonely = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  CGAL::copy_face_graph(icosphere<Mesh>(1, 2.), mesh);
  mesh.remove_vertex(garbage);
  const Exact exact(mesh);
  EXPECT_EQ(exact.index(lonely), 42u);
  const Eigen::MatrixXd d
    = exact.distances(std::vector<Mesh::Vertex_index>{vertex(mesh, 3), lonely, vertex(mesh, 60)});
  ASSERT_EQ(d.rows(), 85);
  EXPECT_TRUE(d.col(0).head(42).allFinite());
  EXPECT_TRUE((d.col(0).tail(43).array() == INF).all());
  EXPECT_EQ(d(42, 1), 0.);
  EXPECT_TRUE((d.col(1).head(42).array() == INF).all() && (d.col(1).tail(42).array() == INF).all());
  EXPECT_TRUE((d.col(2).head(43).array() == INF).all());
  EXPECT_TRUE(d.col(2).tail(42).allFinite());
}

// The same inputs as for the heat method are refused, and faces without area, which cannot be
// unfolded.
} // namespace test_exact_geodesics
