// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Conforming_body_3.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "bar_body.h"

namespace test_body_deformer {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

using Deformer = CP::Body_deformer_3<CP::Conforming_body_3>;

// The boundary as rows of the body, all of whose vertices are surface vertices.
shapes::Triangles boundary_rows(const shapes::Tetrahedral_soup& body)
{
  std::vector<std::size_t> origin;
  shapes::Triangles triangles = shapes::boundary(body, &origin).triangles;
  for(auto& t : triangles)
    for(std::size_t& v : t)
      v = origin[v];
  return triangles;
}

// Positive numbers with sum 1.
Eigen::RowVectorXd random_shares(CGAL::Random& random, const Eigen::Index n)
{
  Eigen::RowVectorXd result(n);
  for(Eigen::Index k = 0; k < n; ++k)
    result[k] = random.get_double(0.01, 1.);
  return result / result.sum();
}

CP::Point_matrix random_points(CGAL::Random& random, const Eigen::Index n)
{
  CP::Point_matrix result(n, 3);
  for(Eigen::Index i = 0; i < n; ++i)
    for(Eigen::Index k = 0; k < 3; ++k)
      result(i, k) = random.get_double(-1., 1.);
  return result;
}

// Barycentric coordinates reproduce affine functions, inside a cell, on its boundary and outside:
// only rounding errors remain, proportional to the distance.
TEST(Body_deformer, is_exact_for_affine_functions)
{
  const shapes::Tetrahedral_soup soup = shapes::tetrahedral_bent_bar(12, 2, 2, 1.);
  const CP::Conforming_body_3 body = shapes::to_body(soup);
  const Deformer deformer(body, boundary_rows(soup));
  CGAL::Random random(2);
  Eigen::Matrix3d map;
  map << 1, 2, 0, 0.5, -1, 3, 0, 0.2, 1;
  for(const double distance : {0., 0.1, 10., 1e5})
  {
    const CP::Point_matrix points
      = body.points() + distance * random_points(random, body.points().rows());
    const Eigen::SparseMatrix<double> embedding = deformer.embedding(points);
    const double tolerance = 1e-11 * (1 + distance);
    EXPECT_LE((embedding * body.points() - points).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_LE((embedding * (body.points() * map) - points * map).cwiseAbs().maxCoeff(),
              10 * tolerance);
    const Eigen::VectorXd sums = embedding * Eigen::VectorXd::Ones(body.points().rows());
    EXPECT_LE((sums.array() - 1).abs().maxCoeff(), tolerance);
  }
}

// A bar of one row of boxes, in which each cell has corners on every side of its box: a point in a
// cell is embedded in that cell, so it follows any motion of the corners with the same coordinates.
TEST(Body_deformer, points_in_cells_follow_their_corners)
{
  const shapes::Tetrahedral_soup soup = shapes::tetrahedral_box(20, 1, 1, {{8., 1., 1.}});
  const CP::Conforming_body_3 body = shapes::to_body(soup);
  const Deformer deformer(body, boundary_rows(soup));
  CGAL::Random random(3);
  const CP::Point_matrix pose = random_points(random, body.points().rows());
  CP::Point_matrix points(Eigen::Index(body.cells().size()), 3), expected = points;
  for(std::size_t t = 0; t < body.cells().size(); ++t)
  {
    const Eigen::RowVectorXd shares = random_shares(random, 4);
    const Eigen::Index i = Eigen::Index(t);
    points.row(i).setZero();
    expected.row(i).setZero();
    for(std::size_t k = 0; k < 4; ++k)
    {
      points.row(i) += shares[Eigen::Index(k)] * body.points().row(body.cells()[t][k]);
      expected.row(i) += shares[Eigen::Index(k)] * pose.row(body.cells()[t][k]);
    }
  }
  const Eigen::SparseMatrix<double> embedding = deformer.embedding(points);
  EXPECT_LE((embedding * pose - expected).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((deformer.embedding(body.points()) * pose - pose).cwiseAbs().maxCoeff(), 1e-12);
}

// A bar bent by more than 360 degrees, and skewed: its ends overlap, but no faces coincide. When
// the bar is straightened, points on the surface of either end follow this end, like the corners of
// their triangle; so do points slightly inside.
TEST(Body_deformer, points_follow_the_part_that_they_lie_on)
{
  shapes::Tetrahedral_soup soup = shapes::tetrahedral_box(40, 1, 1, {{8., 1., 1.}});
  const CP::Point_matrix straight = shapes::to_matrix(soup.points);
  for(auto& p : soup.points)
    p = shapes::bend({{p[0], p[1] + 0.3 * p[0] / 8, p[2] + 0.2 * p[0] / 8 - 0.5}}, 8., 6.8);
  const CP::Conforming_body_3 body = shapes::to_body(soup);
  const shapes::Triangles triangles = boundary_rows(soup);
  const Deformer deformer(body, triangles);
  CGAL::Random random(4);
  CP::Point_matrix points(Eigen::Index(triangles.size()), 3), expected = points;
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    const Eigen::RowVectorXd shares = random_shares(random, 3);
    points.row(Eigen::Index(f)).setZero();
    expected.row(Eigen::Index(f)).setZero();
    for(std::size_t k = 0; k < 3; ++k)
    {
      points.row(Eigen::Index(f))
        += shares[Eigen::Index(k)] * body.points().row(Eigen::Index(triangles[f][k]));
      expected.row(Eigen::Index(f))
        += shares[Eigen::Index(k)] * straight.row(Eigen::Index(triangles[f][k]));
    }
  }
  EXPECT_LE((deformer.embedding(points) * straight - expected).cwiseAbs().maxCoeff(), 1e-10);
  const CP::Point_matrix near_points = points + 1e-6 * random_points(random, points.rows());
  EXPECT_LE((deformer.embedding(near_points) * straight - expected).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Body_deformer, names_bad_input)
{
  const CP::Conforming_body_3 body = shapes::bar_body(2, 1, 1);
  EXPECT_THROW_WITH(Deformer(body, {}), std::invalid_argument, "no triangle");
  EXPECT_THROW_WITH(Deformer(body, {{{0, 1, 1}}, {{0, 1, 2}}}), std::invalid_argument,
                    "no triangle");
  const Deformer deformer(body, boundary_rows(shapes::tetrahedral_bent_bar(2, 1, 1, 0)));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW_WITH(deformer.embedding(CP::Point_matrix::Constant(1, 3, infinity)),
                    std::invalid_argument, "not finite");
  EXPECT_EQ(deformer.embedding(CP::Point_matrix(0, 3)).rows(), 0);
}

} // namespace test_body_deformer
