// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/intrinsic/cotangent_operators.h"
#include "Triangle_graph.h"
#include "geodesic_fixtures.h"

#include <CGAL/Canonical_pose_3/Biharmonic_distances_3.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Polyhedron_3.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_biharmonic_distances {

using namespace Canonical_pose_test;
namespace CP = CGAL::Canonical_pose_3;
using Biharmonic = CP::Biharmonic_distances_3<Mesh>;

const double INF = std::numeric_limits<double>::infinity();

// All distances from vertex 0 by the definition with Green's functions, without eigenvalues: with Z
// the inverse of the Laplacian on functions of mean 0, they are obtained from Z M Z.
Eigen::VectorXd distances_by_green(const Mesh& mesh)
{
  const auto rows = CP::internal::number_vertices(mesh);
  const CP::internal::Delaunay_surface surface(CP::internal::face_corners(mesh, rows),
                                               CP::point_matrix(mesh));
  const Eigen::VectorXd m = CP::internal::lumped_mass(surface.triangulation());
  const Eigen::MatrixXd l = CP::internal::cotangent_laplacian(surface.triangulation());
  const Eigen::Index n = m.size();
  const Eigen::MatrixXd z
    = (l + m * m.transpose() / m.sum()).inverse() - Eigen::MatrixXd::Constant(n, n, 1 / m.sum());
  const Eigen::MatrixXd g = z * m.asDiagonal() * z;
  const Eigen::VectorXd squares
    = g.diagonal() + Eigen::VectorXd::Constant(n, g(0, 0)) - 2 * g.col(0);
  return std::ldexp(1., surface.exponent()) * squares.cwiseMax(0).cwiseSqrt();
}

// With all eigenfunctions, the sum equals the definition by Green's functions, which requires no
// eigenvalues. There are fewer eigenfunctions than requested.
TEST(Biharmonic_distances, equal_those_by_green_functions)
{
  for(const Mesh& mesh :
      {icosphere<Mesh>(2, 3.), torus<Mesh>(14, 9, 1., 0.4), to_mesh<Mesh>(stretched_square(9, 5.))})
  {
    const Eigen::VectorXd expected = distances_by_green(mesh);
    const Eigen::VectorXd d = Biharmonic(mesh, 1000).distances(vertex(mesh, 0));
    EXPECT_LT((d - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.maxCoeff());
    EXPECT_EQ(d[0], 0.);
  }
}

// On the unit sphere the eigenvalues are l (l + 1), each 2l + 1 times, and the sum over an eigenspace
// is the Legendre polynomial: up to degree 9, 99 functions. The faces are 0.04 wide, and the error is of
// second order in the width times the degree.
TEST(Biharmonic_distances, sphere)
{
  const Triangle_soup soup = icosphere_soup(5, 1.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::VectorXd d = Biharmonic(mesh, 99).distances(vertex(mesh, 0));
  double largest_error = 0;
  for(std::size_t i = 1; i < soup.points.size(); ++i)
  {
    double cosine = 0, sum = 0;
    for(std::size_t k = 0; k < 3; ++k)
      cosine += soup.points[0][k] * soup.points[i][k];
    cosine = (std::max)(-1., (std::min)(1., cosine));
    for(unsigned int l = 1; l <= 9; ++l)
      sum += (2 * l + 1) / (2 * pi) * (1 - std::legendre(l, cosine)) / std::pow(l * (l + 1.), 2);
    largest_error
      = (std::max)(largest_error, std::abs(d[static_cast<Eigen::Index>(i)] / std::sqrt(sum) - 1));
  }
  EXPECT_LT(largest_error, 0.01);
}

// Euclidean distances between points of the embedding: bitwise symmetric, and a metric up to
// rounding.
TEST(Biharmonic_distances, are_a_metric)
{
  const Mesh mesh = torus<Mesh>(30, 16, 1., 0.4);
  const Biharmonic biharmonic(mesh, 30);
  const Eigen::MatrixXd d = biharmonic.distances(vertices(mesh));
  EXPECT_TRUE(d == d.transpose());
  EXPECT_TRUE(d.col(7) == biharmonic.distances(vertex(mesh, 7)));
  for(Eigen::Index i = 0; i < 20; ++i)
    for(Eigen::Index j = 0; j < d.rows(); j += 7)
      EXPECT_LT((d.col(i).array() - d.col(j).array()).abs().maxCoeff(), d(i, j) + 1e-12);
}

// A power of two changes no bit, even for numbers near the ends of the range; components and
// isolated vertices are independent of each other.
TEST(Biharmonic_distances, scale_and_components)
{
  Triangle_soup soup = torus_soup(24, 12, 1., 0.4);
  const std::size_t n = soup.points.size();
  const Mesh mesh_alone = to_mesh<Mesh>(soup);
  const Eigen::VectorXd alone = Biharmonic(mesh_alone, 20).distances(vertex(mesh_alone, 0));
  for(const int exponent : {-300, 300})
  {
    Triangle_soup scaled = soup;
    for(auto& p : scaled.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    const Mesh mesh = to_mesh<Mesh>(scaled);
    EXPECT_TRUE(Biharmonic(mesh, 20).distances(vertex(mesh, 0))
                == std::ldexp(1., exponent) * alone);
  }
  const Triangle_soup other = icosphere_soup(1, 1.);
  for(const auto& p : other.points)
    soup.points.push_back({{p[0] + 5, p[1], p[2]}});
  for(const auto& t : other.triangles)
    soup.triangles.push_back({{t[0] + n, t[1] + n, t[2] + n}});
  Mesh mesh = to_mesh<Mesh>(soup);
  const auto isolated = mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  const Biharmonic biharmonic(mesh, 20);
  const Eigen::VectorXd d = biharmonic.distances(vertex(mesh, 0));
  EXPECT_LT((d.head(alone.size()) - alone).cwiseAbs().maxCoeff(), 1e-7 * alone.maxCoeff());
  EXPECT_EQ(d.tail(d.size() - alone.size()).minCoeff(), INF);
  const Eigen::VectorXd e = biharmonic.distances(isolated);
  EXPECT_EQ(e[e.size() - 1], 0.);
  EXPECT_EQ(e.head(e.size() - 1).minCoeff(), INF);
}

// Same order of vertices and faces, same bytes.
TEST(Biharmonic_distances, polyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Triangle_soup soup = torus_soup(30, 16, 1., 0.4);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Polyhedron polyhedron = to_mesh<Polyhedron>(soup);
  EXPECT_TRUE(
    Biharmonic(mesh, 10).distances(vertex(mesh, 3))
    == CP::Biharmonic_distances_3<Polyhedron>(polyhedron, 10).distances(vertex(polyhedron, 3)));
}

// A graph without optional features, own points without a kernel, a property map, and another solver.
// All eigenfunctions are used, since a solver may order those of equal eigenvalues differently.
TEST(Biharmonic_distances, archetypes)
{
  using ::archetype::Hashed_graph;
  const Triangle_soup soup = stretched_square(9, 5.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::VectorXd expected = Biharmonic(mesh, 1000).distances(vertex(mesh, 3));

  const Hashed_graph graph(soup);
  const CP::Biharmonic_distances_3<Hashed_graph> on_graph(graph, 1000);
  const Hashed_graph::Vertex_map<float> written{
    std::make_shared<std::vector<float>>(soup.points.size())};
  on_graph.distances({3}, written);
  EXPECT_EQ(on_graph.distances(Hashed_graph::Vertex{3}), expected);
  EXPECT_EQ(*written.values,
            std::vector<float>(expected.data(), expected.data() + expected.size()));

  std::map<Mesh::Vertex_index, Canonical_pose_test::archetype::Point> points;
  for(const auto v : mesh.vertices())
    points.emplace(v, Canonical_pose_test::archetype::Traits().construct_point_3_object()(
                        mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  using Point_map = boost::const_associative_property_map<
    std::map<Mesh::Vertex_index, Canonical_pose_test::archetype::Point>>;
  const CP::Biharmonic_distances_3<Mesh, Point_map, Canonical_pose_test::archetype::Traits,
                                   CP::Eigen_factor_traits_d>
    with_own_parts(mesh, Point_map(points), 1000);
  EXPECT_LT((with_own_parts.distances(vertex(mesh, 3)) - expected).cwiseAbs().maxCoeff(),
            1e-9 * expected.maxCoeff());
}

TEST(Biharmonic_distances, refuse_by_name)
{
  Mesh mesh = icosphere<Mesh>(1, 1.);
  EXPECT_THROW(Biharmonic(mesh, 0), std::invalid_argument);
  const Mesh empty;
  EXPECT_THROW(Biharmonic{empty}, std::invalid_argument);
  mesh.point(Mesh::Vertex_index(3)) = Kernel::Point_3(0, NAN, 0);
  EXPECT_NE(message_of<std::invalid_argument>([&] { Biharmonic{mesh}; }).find("vertex 3"),
            std::string::npos);
}

TEST(Biharmonic_distances, landmarks_by_fronts_on_own_points)
{
  using CGAL::Canonical_pose_3::Biharmonic_distances_3;
  expect_fronts_on_own_points<Biharmonic_distances_3<Mesh>,
                              Biharmonic_distances_3<Mesh, Mesh_with_points::Point_map>>();
}

} // namespace test_biharmonic_distances
