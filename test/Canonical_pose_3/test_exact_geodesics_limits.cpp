// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"
#include "engine/wavefront/find_shortest_paths.h"
#include "matchers.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <utility>

namespace test_exact_geodesics_limits {

using namespace Canonical_pose_test;
using Exact = CGAL::Canonical_pose_3::Exact_geodesics_3<Mesh>;

Triangle_soup scaled(Triangle_soup soup, const double x, const double y, const double z)
{
  for(auto& p : soup.points)
    p = {{x * p[0], y * p[1], z * p[2]}};
  return soup;
}

Triangle_soup joined(Triangle_soup a, const Triangle_soup& b)
{
  for(auto t : b.triangles)
    a.triangles.push_back(
      {{t[0] + a.points.size(), t[1] + a.points.size(), t[2] + a.points.size()}});
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  return a;
}

// A cone of rings, each half the size of the previous one, with similar faces.
Triangle_soup cone(const std::size_t rings)
{
  const std::size_t n = 6;
  Triangle_soup result;
  for(std::size_t i = 0; i < rings * n; ++i)
  {
    const double angle = 2 * pi * (double(i % n) + double(i / n) / 2) / n;
    const double radius = std::ldexp(1., -int(i / n));
    result.points.push_back({{radius * std::cos(angle), radius * std::sin(angle), radius / 4}});
  }
  for(std::size_t i = 0; i + n < rings * n; ++i)
  {
    const std::size_t next = i - i % n + (i + 1) % n;
    result.triangles.push_back({{i, next, i + n}});
    result.triangles.push_back({{next, next + n, i + n}});
  }
  return result;
}

// In a convex planar region, the shortest path is the straight segment.
void expect_straight(const Triangle_soup& soup, const double tolerance)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::MatrixXd d = Exact(mesh).distances(mesh.vertices());
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    EXPECT_LT((d.col(Eigen::Index(i)) - straight_distances(soup.points, i)).cwiseAbs().maxCoeff(),
              tolerance);
}

// No vertex is farther than through a neighbor, nor nearer than the Euclidean distance.
void expect_consistent(const Triangle_soup& soup)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::MatrixXd d = Exact(mesh).distances(mesh.vertices());
  const double rounding = 1e-11 * d.maxCoeff();
  const auto length = [&](const std::size_t i, const std::size_t j) {
    return straight_distances(soup.points, i)[static_cast<Eigen::Index>(j)];
  };
  for(const auto& [a, b, c] : soup.triangles)
    for(const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      EXPECT_LT((d.row(Eigen::Index(i)) - d.row(Eigen::Index(j))).cwiseAbs().maxCoeff(),
                length(i, j) + rounding);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    EXPECT_GT((d.col(static_cast<Eigen::Index>(i)) - straight_distances(soup.points, i)).minCoeff(),
              -rounding);
}

void expect_refusal(const Triangle_soup& soup, const char* defect)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  EXPECT_THROW_WITH(Exact exact(mesh), std::invalid_argument, defect);
}

// Integer coordinates are exact at any place, and so are their differences.
TEST(Exact_geodesics, place_does_not_matter)
{
  Triangle_soup soup = plane_grid_soup(6, 4, 6, 4);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::MatrixXd expected = Exact(mesh).distances(mesh.vertices());
  for(auto& p : soup.points)
    for(double& x : p)
      x += 1e14;
  const Mesh moved = to_mesh<Mesh>(soup);
  EXPECT_LT((Exact(moved).distances(moved.vertices()) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

// In regular rows of thin faces, CGAL misses some paths: vertices were half the grid too far, or
// not reached at all.
TEST(Exact_geodesics, regular_rows_of_thin_faces)
{
  for(const double thinness : {1e-2, 5.623413e-4, 3.162278e-4, 1e-4, 1e-6, 1e-9, 1e-12})
    for(const std::size_t n : {std::size_t(6), std::size_t(9)})
      expect_straight(scaled(plane_grid_soup(n, n, 1, 1), 1, thinness, 1), 5e-7);
  for(const double thinness : {1e-3, 1e-4, 1e-8, 1e-11})
  {
    expect_consistent(tube_soup(6, 6, 1, thinness));
    expect_consistent(tube_soup(6, 6, thinness, 1));
  }
}

// Irregular needles and caps cause no trouble: in the plane, distances are exact up to the limits
// at which faces are refused.
TEST(Exact_geodesics, thin_faces_in_any_order)
{
  for(const double thinness : {1e-2, 1e-6, 1e-10, 1e-12})
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-0.1, 0.1);
    Triangle_soup soup = plane_grid_soup(4, 4, 1, 1);
    for(std::size_t i = 0; i < soup.points.size(); ++i)
    {
      auto& p = soup.points[i]; // points on the sides stay there: the outline is convex
      if(p[0] > 0 && p[0] < 1)
        p[0] += shift(random);
      if(p[1] > 0 && p[1] < 1)
        p[1] += shift(random);
    }
    expect_straight(scaled(soup, 1, thinness, 1), 1e-9);
    expect_consistent(scaled(icosphere_soup(1, 1), 1, 1, thinness));
  }
}

// Faces whose shape is dominated by rounding errors are refused: CGAL returned infinite numbers or
// terminated the program. Exceptions of its assertions are converted.
TEST(Exact_geodesics, faces_beyond_the_range_of_numbers)
{
  for(const double thinness : {1e-15, 1e-20, 1e-70, 1e-160})
  {
    expect_refusal(scaled(icosphere_soup(0, 1), 1, 1, thinness), "too thin for exact distances");
    expect_refusal(scaled(icosphere_soup(1, 1), thinness, thinness, 1), "for exact distances");
    expect_refusal(scaled(plane_grid_soup(6, 6, 1, 1), 1, thinness, 1),
                   "face 0 is too thin for exact distances");
  }
  expect_refusal(cone(60), "face 541 is too small for exact distances");
  const Mesh mesh = to_mesh<Mesh>(cone(45));
  for(const std::size_t i : {0, 6 * 45 - 1})
    EXPECT_TRUE(Exact(mesh).distances(vertex(mesh, i)).allFinite());
  const auto fail = [] { CGAL::assertion_fail("a == b", __FILE__, __LINE__, ""); };
  EXPECT_THROW_WITH(CGAL::Canonical_pose_3::internal::find_shortest_paths(fail), std::runtime_error,
                    "CGAL's shortest paths failed (a == b)");
}

// Components need not have the same size: if one is the other one scaled by a power of two, so are
// its distances, bit by bit.
TEST(Exact_geodesics, components_of_different_sizes)
{
  const Triangle_soup large = icosphere_soup(1, 1);
  for(const int exponent : {-40, -100, -190})
  {
    const double size = std::ldexp(1., exponent);
    const Mesh mesh = to_mesh<Mesh>(joined(large, scaled(large, size, size, size)));
    const Exact exact(mesh);
    EXPECT_EQ(exact.distances(vertex(mesh, 45)).tail(42),
              size * exact.distances(vertex(mesh, 3)).head(42));
  }
  expect_refusal(joined(large, scaled(large, 1e-70, 1e-70, 1e-70)),
                 "face 80 is too small for exact distances");
}

} // namespace test_exact_geodesics_limits
