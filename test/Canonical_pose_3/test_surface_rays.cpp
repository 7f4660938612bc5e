// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <vector>

#include "shapes.h"
#include "surface_with_rays.h"

namespace test_surface_rays {

namespace shapes = Canonical_pose_test;

using shapes::Surface;

// All certain hits are found, with the distance of the plane; no certain misses are reported; hits
// are in the order of distance.
void expect_all_hits(const Surface& s, const int number_of_rays)
{
  CGAL::Random random(3);
  const Eigen::Vector3d low = s.points.colwise().minCoeff(), high = s.points.colwise().maxCoeff();
  const double size = (high - low).norm();
  for(int i = 0; i < number_of_rays; ++i)
  {
    const Eigen::Vector3d place = 0.5 * (shapes::random_vector(random).array() + 1);
    const Eigen::Vector3d origin = low + place.cwiseProduct(high - low);
    Eigen::Vector3d direction = shapes::random_vector(random).normalized();
    if(i % 4 == 0) // along an axis, in either direction
      direction = (i % 8 == 0 ? 1 : -1) * Eigen::Vector3d::Unit(i / 8 % 3);
    const std::vector<shapes::Hit> hits = s.hits(origin, direction);
    std::vector<bool> is_hit(s.triangles.size(), false);
    for(std::size_t k = 0; k < hits.size(); ++k)
    {
      EXPECT_LE(k > 0 ? hits[k - 1].distance : 0, hits[k].distance);
      EXPECT_FALSE(is_hit[hits[k].face]) << "twice";
      is_hit[hits[k].face] = true;
    }
    for(std::size_t f = 0; f < s.triangles.size(); ++f)
    {
      const shapes::Meeting m = shapes::meeting(s, f, origin, direction);
      if(m.is_parallel)
        continue;
      if(is_hit[f])
        EXPECT_TRUE(m.inside > -1e-7 && m.distance > -1e-9 * size) << "ray " << i << ", face " << f;
      else
        EXPECT_FALSE(m.inside > 1e-7 && m.distance > 1e-9 * size) << "ray " << i << ", face " << f;
    }
    for(const shapes::Hit& hit : hits)
    {
      const shapes::Meeting m = shapes::meeting(s, hit.face, origin, direction);
      EXPECT_TRUE(m.is_parallel || std::abs(hit.distance - m.distance) <= 1e-7 * size);
      EXPECT_TRUE(m.is_parallel || hit.is_exit == m.is_exit);
    }
  }
}

// Hits do not depend on the grid: they are compared with the formula, face by face. Boxes of 12
// faces and long tubes have faces that intersect many cells.
TEST(Surface_rays, find_what_the_formula_finds)
{
  expect_all_hits(Surface(shapes::icosphere_soup(3, 1.)), 200);
  expect_all_hits(Surface(shapes::plane_grid_soup(20, 10, 2., 1.)), 100);
  expect_all_hits(Surface(shapes::boundary(shapes::tetrahedral_box(1, 1, 1, {{9., 1., 0.2}}))),
                  200);
  expect_all_hits(Surface(shapes::tube_soup(2, 40, 10., 0.3)), 200);
  expect_all_hits(Surface(shapes::needles(2000, 0.01)), 100);
  shapes::Triangle_soup tube = shapes::tube_soup(30, 12, 3., 0.5);
  for(auto& p : tube.points)
    p = {{p[0] - 1.5, p[1] + 0.1, p[2]}};
  expect_all_hits(Surface(shapes::joined(shapes::icosphere_soup(3, 1.), tube)), 200);
}

// The grid scales with the surface.
TEST(Surface_rays, of_any_unit)
{
  const shapes::Triangle_soup soup
    = shapes::joined(shapes::icosphere_soup(2, 1.), shapes::tube_soup(2, 12, 3., 0.2));
  for(const double unit : {std::ldexp(1., -200), 1e-6, 1e9, std::ldexp(1., 200)})
    expect_all_hits(Surface(soup, unit), 50);
}

// From the inside of a convex surface, every ray exits: through a vertex, an edge, or along an axis
// through a face on the border of the grid. The exit is known for vertices and edges.
TEST(Surface_rays, do_not_slip_through)
{
  for(const shapes::Triangle_soup& soup :
      {shapes::icosphere_soup(2, 1.), shapes::boundary(shapes::tetrahedral_box(7, 5, 3))})
  {
    const Surface s(soup);
    const Eigen::Vector3d box_center(0.41, 0.37, 0.63), sphere_center(0.013, -0.017, 0.019);
    const Eigen::Vector3d origin = s.points.minCoeff() < 0 ? sphere_center : box_center;
    for(std::size_t f = 0; f < s.triangles.size(); ++f)
      for(std::size_t k = 0; k < 3; ++k)
        for(const double t : {0., 0.25, 0.5})
        {
          const Eigen::Vector3d goal = (1 - t) * s.corner(f, k) + t * s.corner(f, (k + 1) % 3);
          const std::vector<shapes::Hit> hits = s.hits(origin, (goal - origin).normalized());
          ASSERT_FALSE(hits.empty()) << f << " " << k << " " << t;
          EXPECT_TRUE(hits[0].is_exit);
          EXPECT_NEAR(hits[0].distance, (goal - origin).norm(), 1e-12);
        }
    CGAL::Random random(1);
    for(int i = 0; i < 3000; ++i)
    {
      const Eigen::Vector3d direction = (i % 2 == 0 ? 1 : -1) * Eigen::Vector3d::Unit(i % 3);
      EXPECT_FALSE(s.hits(origin + 0.3 * shapes::random_vector(random), direction).empty());
    }
  }
}

// The bounding boxes of these needles have a hundred thousand cells each, which took minutes; the
// needles intersect a few dozen.
TEST(Surface_rays, of_many_needles)
{
  const std::size_t n = 40000;
  const Surface s(shapes::needles(n, 1e-5));
  std::size_t found = 0;
  for(std::size_t f = 0; f < n; f += 80)
  {
    const Eigen::Vector3d middle = (s.corner(f, 0) + s.corner(f, 1) + s.corner(f, 2)) / 3;
    const Eigen::Vector3d normal
      = (s.corner(f, 1) - s.corner(f, 0)).cross(s.corner(f, 2) - s.corner(f, 0)).normalized();
    for(const shapes::Hit& hit : s.hits(middle - 0.05 * normal, normal))
      if(hit.face == f)
      {
        ++found;
        EXPECT_NEAR(hit.distance, 0.05, 1e-7);
      }
  }
  EXPECT_EQ(found, n / 80);
}

} // namespace test_surface_rays
