// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repaired.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_repair_non_manifold {

// Repair of surfaces that are not manifold, have holes or unusual sizes. Counts and volumes are
// known by construction; repaired() checks the guarantees for all surfaces.

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

std::size_t copies_of(const CP::Repaired_surface_3& surface, const std::size_t row)
{
  return std::size_t(std::count(surface.origins.begin(), surface.origins.end(), row));
}

std::size_t triangles_of(const CP::Repaired_surface_3& surface, const std::size_t component)
{
  return CP::component_of_surface(surface, component).triangles.size();
}

TEST(Repair, pinched_vertex_is_split)
{
  const auto surface = repaired(pinched_balls());
  EXPECT_EQ(surface.number_of_components, 2u);
  EXPECT_EQ(surface.origins.size(), 24u);
  EXPECT_EQ(copies_of(surface, 8), 2u);
  EXPECT_TRUE(surface.caps.empty());
}

TEST(Repair, bow_tie)
{
  const auto surface
    = repaired({{{{0, 0, 0}}, {{1, 1, 0}}, {{1, -1, 0}}, {{-1, 1, 0}}, {{-1, -1, 0}}},
                {{0, 2, 1}, {0, 3, 4}}});
  EXPECT_EQ(surface.number_of_components, 2u);
  EXPECT_EQ(copies_of(surface, 0), 2u);
  EXPECT_EQ(surface.caps.size(), 2u);
}

// The ball remains closed, on whichever side the fin is.
TEST(Repair, fin)
{
  for(const std::array<double, 3>& tip : Points{{{-3., 3., 0.}}, {{0.1, 0., 0.}}})
    for(const bool is_turned : {false, true})
    {
      Polygon_soup soup = ball_with_fin();
      soup.points[12] = tip;
      if(is_turned)
        std::swap(soup.polygons.back()[0], soup.polygons.back()[1]);
      const auto surface = repaired(soup);
      ASSERT_EQ(surface.number_of_components, 2u);
      EXPECT_EQ(triangles_of(surface, surface.component_of_triangle[0]), 20u);
      EXPECT_EQ(surface.caps.size(), 1u); // of the fin
    }
}

TEST(Repair, cubes_with_a_common_edge_stay_two)
{
  const auto surface = repaired(cubes_with_a_common_edge());
  EXPECT_EQ(surface.number_of_components, 2u);
  EXPECT_EQ(copies_of(surface, 3), 2u);
  EXPECT_EQ(copies_of(surface, 7), 2u);
  EXPECT_TRUE(surface.caps.empty());
  EXPECT_DOUBLE_EQ(volume(surface), 2);
}

// A wall shared by two cubes is a single face; at most one cube keeps it.
TEST(Repair, cubes_with_a_common_wall)
{
  Polygon_soup soup = merged(quad_cube(), quad_cube(), 1.);
  for(const std::size_t v : {1, 3, 5, 7})
    soup = renamed(soup, 8 + v - 1, v);
  const auto surface = repaired(soup);
  EXPECT_EQ(surface.triangles.size(), 22u);
  EXPECT_NEAR(volume(surface), 2, 1e-12);
}

// A tube with a common edge of four faces, around which only one pairing is possible.
TEST(Repair, edges_that_coincide_are_cut)
{
  Polygon_soup soup = quad_cube(); // a square tube along z; two opposite edges of its wall coincide
  soup.polygons = {{0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  soup = renamed(renamed(soup, 3, 0), 7, 4);
  const auto surface = repaired(soup);
  EXPECT_EQ(surface.triangles.size(), 8u);
  EXPECT_EQ(copies_of(surface, 0), 2u);
}

// Half a twist: there is no orientation, so at least one cut across the band is required.
TEST(Repair, moebius_strip_is_cut)
{
  const auto surface = repaired(moebius_strip(20));
  EXPECT_EQ(surface.triangles.size(), 40u);
  EXPECT_EQ(surface.number_of_components, 1u);
  EXPECT_EQ(surface.origins.size(), 42u);
  repaired(moebius_strip(3));
}

TEST(Repair, holes_are_capped_without_new_vertices)
{
  Polygon_soup soup = to_polygons(torus_soup(12, 8, 2., 0.5));
  soup.polygons.erase(soup.polygons.begin() + 70);
  soup.polygons.erase(soup.polygons.begin(), soup.polygons.begin() + 2);
  EXPECT_EQ(repaired(soup).caps.size(), 1 + 2u);

  // The boundary of a disk of 300 triangles around its center, and of a cone; the caps are flat.
  soup = {{{{0, 0, 1}}}, {}};
  for(std::size_t i = 0; i < 300; ++i)
  {
    soup.points.push_back(
      {{std::cos(2 * pi * double(i) / 300), std::sin(2 * pi * double(i) / 300), 0}});
    soup.polygons.push_back({0, 1 + i, 1 + (i + 1) % 300});
  }
  EXPECT_EQ(repaired(soup).caps.size(), 298u);
  EXPECT_NEAR(volume(repaired(soup)), pi / 3, 1e-3);
}

TEST(Repair, components_by_decreasing_area)
{
  Polygon_soup large = ball();
  for(auto& p : large.points)
    p = {{3 * p[0], 3 * p[1], 3 * p[2]}};
  Polygon_soup soup = merged(ball(), large, 10.);
  soup.points.push_back({{7, 7, 7}}); // isolated: no copy
  const auto surface = repaired(soup);
  EXPECT_EQ(surface.number_of_components, 2u);
  EXPECT_EQ(surface.component_of_triangle.front(), 1u);
  EXPECT_EQ(surface.component_of_triangle.back(), 0u);
  EXPECT_EQ(copies_of(surface, 24), 0u);
  EXPECT_EQ(CP::component_of_surface(surface, 0).origins.front(), 12u);
}

TEST(Repair, scale_does_not_matter)
{
  for(const double scale : {1e150, 1e-150})
    for(const Polygon_soup& soup : {unsewn(quad_cube()), ball_with_fin(), moebius_strip(20)})
    {
      Polygon_soup scaled = soup;
      for(auto& p : scaled.points)
        p = {{scale * p[0], scale * p[1], scale * p[2]}};
      EXPECT_EQ(repaired(scaled).triangles, repaired(soup).triangles);
      EXPECT_EQ(repaired(scaled).caps, repaired(soup).caps);
    }
}

} // namespace test_repair_non_manifold
