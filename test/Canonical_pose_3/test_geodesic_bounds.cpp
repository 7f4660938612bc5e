// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "shapes.h"

namespace test_geodesic_bounds {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

Rows rows(const shapes::Triangle_soup& soup)
{
  Rows result(Eigen::Index(soup.points.size()), 3);
  for(Eigen::Index i = 0; i < result.rows(); ++i)
    for(Eigen::Index k = 0; k < 3; ++k)
      result(i, k) = soup.points[std::size_t(i)][std::size_t(k)];
  return result;
}

// All distances on the unit sphere.
Eigen::MatrixXd sphere_distances(const Rows& points)
{
  Eigen::MatrixXd result(points.rows(), points.rows());
  for(Eigen::Index j = 0; j < points.rows(); ++j)
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      result(i, j) = 2 * std::asin((std::min)(1., (points.row(i) - points.row(j)).norm() / 2));
  return result;
}

Eigen::MatrixXd plane_distances(const Rows& points)
{
  Eigen::MatrixXd result(points.rows(), points.rows());
  for(Eigen::Index j = 0; j < points.rows(); ++j)
    result.col(j) = (points.rowwise() - points.row(j)).rowwise().norm();
  return result;
}

// Checks the triangle inequality; distances are stored as floats, with 24 bits. With one column per
// vertex, vertex j is the landmark of column j; the first 32 are used.
void expect_bounds(const Eigen::MatrixXd& distances, const double unit)
{
  const CP::internal::Geodesic_bounds bounds(distances, unit);
  const double rounding = std::ldexp(distances.maxCoeff() / unit, -23);
  for(Eigen::Index v = 0; v < distances.rows(); ++v)
    for(Eigen::Index w = 0; w < distances.rows(); ++w)
    {
      const double bound = bounds(std::size_t(v), std::size_t(w)), exact = distances(v, w) / unit;
      EXPECT_EQ(bound, bounds(std::size_t(w), std::size_t(v)));
      EXPECT_LE(bound, v == w ? 0 : exact + rounding);
      EXPECT_GE(bound, v < 32 ? exact - rounding : 0);
    }
}

TEST(Geodesic_bounds, on_shapes_of_known_distances)
{
  const Eigen::MatrixXd sphere = sphere_distances(rows(shapes::icosphere_soup(2, 1.)));
  const Eigen::MatrixXd plane = plane_distances(rows(shapes::plane_grid_soup(9, 7, 3., 2.)));
  for(const double unit : {1., 3.7, 1e-30, 1e30})
  {
    expect_bounds(sphere, unit * sphere.maxCoeff());
    expect_bounds(plane * unit, unit * plane.maxCoeff());
  }
}

// The bound is the largest difference over the landmarks, up to rounding to floats, also with one
// or two landmarks.
TEST(Geodesic_bounds, with_few_landmarks)
{
  const Rows points = rows(shapes::icosphere_soup(2, 1.));
  const Eigen::MatrixXd all = sphere_distances(points);
  for(const Eigen::Index l : {1, 2})
  {
    const CP::internal::Geodesic_bounds bounds(all.leftCols(l), 1);
    for(Eigen::Index v = 0; v < all.rows(); ++v)
      for(Eigen::Index w = 0; w < all.rows(); ++w)
      {
        const double expected = (all.row(v) - all.row(w)).head(l).cwiseAbs().maxCoeff();
        EXPECT_NEAR(bounds(std::size_t(v), std::size_t(w)), expected, 1e-6);
      }
  }
}

// Distances on a coarse surface are interpolated: between vertices of it, bounds are those of its distances,
// and no bound is larger than the largest difference of these. The unit is the largest distance.
TEST(Geodesic_bounds, of_a_coarse_surface)
{
  const shapes::Triangle_soup soup = shapes::icosphere_soup(3, 1.);
  CP::Surface_component_3 surface;
  surface.points = rows(soup);
  surface.triangles = soup.triangles;
  surface.face_of_triangle.resize(soup.triangles.size());
  surface.origins.resize(soup.points.size());
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, 200);
  ASSERT_LT(coarse.vertices.size(), soup.points.size());
  const Eigen::MatrixXd distances = sphere_distances(coarse.surface.points);
  const double unit = distances.maxCoeff();
  const CP::internal::Geodesic_bounds coarse_bounds(distances, unit);
  CP::internal::Geodesic_bounds bounds(distances, unit);
  bounds.interpolate(coarse);
  EXPECT_EQ(bounds.unit(), unit);
  EXPECT_TRUE(bounds.are_finite());
  for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
    for(std::size_t j = 0; j < coarse.vertices.size(); ++j)
      EXPECT_EQ(bounds(coarse.vertices[i], coarse.vertices[j]), coarse_bounds(i, j));
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(std::size_t w = 0; w < v; ++w)
      EXPECT_LE(bounds(v, w), 1 + 1e-6);
}

// In the plane, the distance of the midpoint of an edge is determined by those of its endpoints,
// even if these are midpoints themselves.
TEST(Geodesic_bounds, of_middles_in_the_plane)
{
  Rows points = rows(shapes::plane_grid_soup(4, 3, 3., 2.));
  const Eigen::Index n = points.rows();
  const Eigen::MatrixXd given = plane_distances(points);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(Eigen::Index i = 0; i < 40; ++i)
  {
    const Eigen::Index v = 7 * i % points.rows(), w = (11 * i + 3) % points.rows();
    edges.emplace_back(std::size_t(v), std::size_t(w));
    points.conservativeResize(points.rows() + 1, 3);
    points.row(points.rows() - 1) = (points.row(v) + points.row(w)) / 2;
  }
  CP::internal::Geodesic_bounds bounds(given, 1);
  bounds.add_middles(edges, points);
  for(Eigen::Index v = n; v < points.rows(); ++v)
    for(Eigen::Index landmark = 0; landmark < n; ++landmark)
      EXPECT_NEAR(bounds(std::size_t(v), std::size_t(landmark)),
                  (points.row(v) - points.row(landmark)).norm(), 1e-3);
}

} // namespace test_geodesic_bounds
