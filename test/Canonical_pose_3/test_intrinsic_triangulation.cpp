// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"
#include "engine/heat/Gradient_field.h"
#include "engine/intrinsic/cotangent_operators.h"
#include "engine/linear_algebra/Sparse_factor.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>

#include <gtest/gtest.h>

namespace test_intrinsic_triangulation {

using namespace Canonical_pose_test;
using namespace CGAL::Canonical_pose_3::internal;

Intrinsic_triangulation triangulation(const Triangle_soup& soup)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Face_corners corners = face_corners(mesh, number_vertices(mesh));
  const auto points = CGAL::Canonical_pose_3::point_matrix(mesh);
  return {soup.points.size(), corners.origins, corners.twins, side_lengths(corners, points)};
}

void expect_delaunay(const Intrinsic_triangulation& t)
{
  for(int h = 0; h < t.number_of_halfedges(); ++h)
  {
    if(!t.is_border(h))
    {
      EXPECT_EQ(t.twin(t.twin(h)), h);
      EXPECT_EQ(t.origin(t.twin(h)), t.target(h));
      EXPECT_EQ(t.length(t.twin(h)), t.length(h));
    }
    EXPECT_TRUE(t.is_border(h) || t.cotangent_sum(h) > -1e-9) << h;
  }
}

// In a convex planar region, flipping based on lengths must yield the Delaunay triangulation of the
// points: the length of every edge, after any number of flips, is the Euclidean distance of its
// endpoints, and the area does not change.
TEST(Intrinsic_triangulation, flips_in_the_plane_are_exact)
{
  const Triangle_soup soup = stretched_square(30, 20.);
  Intrinsic_triangulation t = triangulation(soup);
  EXPECT_NEAR(t.area(), 20., 1e-12);
  EXPECT_GT(t.flip_to_delaunay(), 1000u);
  EXPECT_NEAR(t.area(), 20., 1e-12);
  expect_delaunay(t);
  for(int h = 0; h < t.number_of_halfedges(); ++h)
  {
    const auto &p = soup.points[std::size_t(t.origin(h))],
               &q = soup.points[std::size_t(t.target(h))];
    EXPECT_NEAR(t.length(h), std::hypot(p[0] - q[0], p[1] - q[1]), 1e-13);
  }
  EXPECT_EQ(t.flip_to_delaunay(), 0u);
}

// Two copies of an obtuse triangle, glued along all edges. The long edge is not Delaunay; its flip
// connects the apex to itself around the back: a loop of twice the height 0.1, in two faces glued
// to themselves.
TEST(Intrinsic_triangulation, vertex_that_is_its_own_neighbor)
{
  Intrinsic_triangulation t(
    {3,
     {0, 1, 2, 1, 0, 2},
     {3, 5, 4, 0, 2, 1},
     {2., std::hypot(1., 0.1), std::hypot(1., 0.1), 2., std::hypot(1., 0.1), std::hypot(1., 0.1)}});
  EXPECT_EQ(t.flip_to_delaunay(), 1u);
  EXPECT_EQ(t.origin(0), 2);
  EXPECT_EQ(t.target(0), 2);
  EXPECT_NEAR(t.length(0), 0.2, 1e-14);
  EXPECT_NEAR(t.area(), 0.2, 1e-14);
  expect_delaunay(t);
  const Eigen::MatrixXd laplacian = cotangent_laplacian(t);
  EXPECT_LT(laplacian.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(laplacian(0, 1), 0.);
  EXPECT_NEAR(laplacian(0, 2), -0.1,
              1e-13); // both angles opposite to the glued edge have tangent 10
}

// On a curved surface, faces are unfolded into a plane before each flip: area, vertices and number
// of faces do not change.
TEST(Intrinsic_triangulation, flips_keep_the_surface)
{
  Triangle_soup soup = tube_soup(9, 30, 10., 1.);
  for(auto& p : soup.points) // twisted about its axis
    p = {{p[0], std::cos(p[0]) * p[1] - std::sin(p[0]) * p[2],
          std::sin(p[0]) * p[1] + std::cos(p[0]) * p[2]}};
  Intrinsic_triangulation t = triangulation(soup);
  const double area = t.area();
  EXPECT_GT(t.flip_to_delaunay(), 100u);
  expect_delaunay(t);
  EXPECT_EQ(t.number_of_faces(), 2 * 30 * 9);
  EXPECT_EQ(t.number_of_vertices(), 272u);
  EXPECT_NEAR(t.area(), area, 1e-12 * area);
}

// Collinear or coincident corners lead to faces without area; with mollified lengths, every face
// has a positive area, and no edge changes by more than twice the requested slack.
TEST(Intrinsic_triangulation, mollification)
{
  const Triangle_soup soup{{{{0, 0, 0}}, {{2, 0, 0}}, {{1, 0, 0}}, {{1, -1, 0}}, {{1, -1, 0}}},
                           {{{0, 1, 2}}, {{1, 0, 3}}, {{0, 4, 3}}}};
  Intrinsic_triangulation t = triangulation(soup);
  const Intrinsic_triangulation before = t;
  const std::vector<int> one(5, 0);
  EXPECT_EQ(t.mollify(one, 1, 1e-6), 1);
  for(int h = 0; h < t.number_of_halfedges(); ++h)
  {
    EXPECT_GT(t.length(h), before.length(h));
    EXPECT_LT(t.length(h) - before.length(h), 2e-6 * 2);
  }
  for(int f = 0; f < t.number_of_faces(); ++f)
    EXPECT_GT(t.twice_area(f), 0.);
  t.flip_to_delaunay();
  expect_delaunay(t);
  EXPECT_EQ(triangulation(icosphere_soup(1, 1.)).mollify(std::vector<int>(42, 0), 1), 0);
}

// The operators on linear functions in the plane: their gradient is constant, the Laplacian
// vanishes in the interior, and the Dirichlet energy is the area times the squared slope. The
// Laplacian is always minus the divergence of the gradient: the divergence of the unit descent
// field is that of u divided by the slope, at any scale of the values.
TEST(Cotangent_operators, invariants)
{
  const Triangle_soup soup = stretched_square(12, 2.);
  Intrinsic_triangulation t = triangulation(soup);
  t.flip_to_delaunay();
  const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(t);
  Eigen::VectorXd u(169);
  for(Eigen::Index i = 0; i < 169; ++i)
    u[i] = 3 * soup.points[std::size_t(i)][0] - 4 * soup.points[std::size_t(i)][1];
  EXPECT_NEAR(lumped_mass(t).sum(), 2., 1e-13);
  EXPECT_GT(lumped_mass(t).minCoeff(), 0.);
  EXPECT_LT((laplacian * Eigen::VectorXd::Ones(169)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(Eigen::MatrixXd(laplacian - Eigen::SparseMatrix<double>(laplacian.transpose())).norm(),
            1e-15);
  EXPECT_NEAR(u.dot(laplacian * u), 25. * 2., 1e-11);
  for(std::size_t j = 1; j < 12; ++j)
    for(std::size_t i = 1; i < 12; ++i)
      EXPECT_NEAR((laplacian * u)[Eigen::Index(j * 13 + i)], 0., 1e-11);

  // Lane 5 holds u, the others are constant.
  const auto lane = [&](Lane_rows& rows, std::size_t i, std::size_t k) -> double& {
    return rows[NUMBER_OF_LANES * i + k];
  };
  for(double scale : {1e-300, 1., 1e300})
  {
    Lane_rows rows(NUMBER_OF_LANES * 169, 7 * scale), result(NUMBER_OF_LANES * 169, 0.);
    for(std::size_t i = 0; i < 169; ++i)
      lane(rows, i, 5) = scale * u[Eigen::Index(i)];
    Gradient_field(t).divergence_of_unit_descent(rows, result);
    const Eigen::VectorXd expected = laplacian * u / -5.;
    for(std::size_t i = 0; i < 169; ++i)
      for(std::size_t k = 0; k < NUMBER_OF_LANES; ++k)
        EXPECT_NEAR(lane(result, i, k), k == 5 ? expected[Eigen::Index(i)] : 0., 1e-11);
  }
}

} // namespace test_intrinsic_triangulation
