// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repaired.h"

#include <Eigen/Dense>

#include <array>
#include <limits>
#include <random>
#include <vector>

namespace test_repair_surface {

// Counts, areas and volumes are known by construction; repaired() checks the guarantees for all
// surfaces.

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

TEST(Repair, clean_surface_comes_back_as_it_is)
{
  const auto soup = torus_soup(12, 8, 2., 0.5);
  const auto surface = CP::repair_surface(to_matrix(soup.points), soup.triangles);
  EXPECT_EQ(surface.triangles, soup.triangles);
  EXPECT_EQ(surface.points, to_matrix(soup.points));
  EXPECT_TRUE(surface.caps.empty());
  repaired(to_polygons(soup));
}

TEST(Repair, what_throws)
{
  EXPECT_THROW_WITH(repaired({}), std::invalid_argument, "the surface has no face");
  EXPECT_THROW_WITH(repaired({{{{0, 0, 0}}, {{1, 1, 1}}, {{2, 2, 2}}}, {{0, 1, 2}, {0, 0, 1}}}),
                    std::invalid_argument, "all its faces are degenerate");
  EXPECT_THROW_WITH(repaired({{{{0, 0, 0}}, {{1, 1, 1}}}, {{0, 1}, {}}}), std::invalid_argument,
                    "all its faces are degenerate");
  Polygon_soup soup = ball();
  soup.polygons[7][1] = 12;
  EXPECT_THROW_WITH(repaired(soup), std::invalid_argument,
                    "face 7 names vertex 12, but there are 12");
  soup = ball();
  soup.points[3][2] = std::numeric_limits<double>::infinity();
  EXPECT_THROW_WITH(repaired(soup), std::invalid_argument, "vertex 3 has a coordinate");
  EXPECT_THROW_WITH(CP::component_of_surface(repaired(ball()), 1), std::invalid_argument,
                    "there is no component 1");
}

TEST(Repair, one_triangle)
{
  const auto surface = repaired({{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{0, 1, 2}}});
  EXPECT_EQ(surface.triangles, Triangles({{{0, 1, 2}}})); // flat sheets do not change
  EXPECT_EQ(surface.caps.size(), 1u);
}

TEST(Repair, polygons)
{
  EXPECT_EQ(repaired(quad_cube()).triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(volume(repaired(quad_cube())), 1);
  // An L of six corners and a wall around it, height 1: area of the L is 3.
  Polygon_soup soup;
  for(const double z : {0., 1.})
    for(const auto& p :
        std::vector<std::array<double, 2>>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
      soup.points.push_back({{p[0], p[1], z}});
  soup.polygons = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for(std::size_t i = 0; i < 6; ++i)
    soup.polygons.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  const auto surface = repaired(soup);
  EXPECT_EQ(surface.triangles.size(), 2 * 4 + 6 * 2u);
  EXPECT_DOUBLE_EQ(volume(surface), 3);
  double area = 0;
  for(const auto& t : surface.triangles)
    area += Eigen::Vector3d(surface.points.row(t[1]) - surface.points.row(t[0]))
              .cross(Eigen::Vector3d(surface.points.row(t[2]) - surface.points.row(t[0])))
              .norm()
            / 2;
  EXPECT_DOUBLE_EQ(area, 2 * 3 + 8); // none is folded back
  EXPECT_EQ(surface.face_of_triangle.back(), 7u);
}

TEST(Repair, faces_that_repeat_vertices_or_others)
{
  Polygon_soup soup = ball();
  soup.polygons[3].push_back(soup.polygons[3][2]); // a degenerate quad: a triangle
  soup.polygons.push_back({0, 1, 1});
  soup.polygons.push_back({soup.polygons[5][1], soup.polygons[5][0], soup.polygons[5][2]});
  const auto surface = repaired(soup);
  EXPECT_EQ(surface.triangles.size(), 20u);
  EXPECT_EQ(surface.number_of_components, 1u);
  EXPECT_TRUE(surface.caps.empty());
}

TEST(Repair, orientation)
{
  const double expected = volume(repaired(ball()));
  Polygon_soup soup = ball();
  std::swap(soup.polygons[4][0], soup.polygons[4][1]);
  EXPECT_DOUBLE_EQ(volume(repaired(soup)), expected);
  for(auto& polygon : soup.polygons)
    std::swap(polygon[0], polygon[2]);
  EXPECT_DOUBLE_EQ(volume(repaired(soup)), expected);
}

TEST(Repair, soup_of_separate_faces_is_sewn)
{
  for(const Polygon_soup& closed : {ball(), quad_cube()})
  {
    const auto surface = repaired(unsewn(closed));
    EXPECT_EQ(surface.origins.size(), closed.points.size());
    EXPECT_TRUE(surface.caps.empty());
    EXPECT_EQ(surface.number_of_components, 1u);
    for(std::size_t v = 0; v < surface.representatives.size(); ++v)
      EXPECT_EQ(unsewn(closed).points[v], unsewn(closed).points[surface.representatives[v]]);
  }
}

// Two balls that touch at a vertex remain separate; the vertices are not on a boundary.
TEST(Repair, closed_surfaces_that_touch_are_not_glued)
{
  const double gap = 2 * ball().points[8][0];
  const auto surface = repaired(merged(ball(), ball(), gap));
  EXPECT_EQ(surface.number_of_components, 2u);
  EXPECT_EQ(surface.origins.size(), 24u);
}

// Random faces over few vertices: nearly every edge has many faces. Only the guarantees for all
// surfaces are checked.
TEST(Repair, random_soups)
{
  std::mt19937 random(1);
  for(int round = 0; round < 300; ++round)
  {
    Polygon_soup soup;
    const std::size_t n = 4 + random() % 8;
    for(std::size_t v = 0; v < n; ++v)
      soup.points.push_back({{double(random() % 5), double(random() % 5), double(random() % 5)}});
    for(std::size_t f = 0; f < 1 + random() % 40; ++f)
    {
      soup.polygons.emplace_back();
      for(std::size_t k = 0; k < 3 + random() % 3; ++k)
        soup.polygons.back().push_back(random() % n);
    }
    const Point_matrix points = to_matrix(soup.points);
    try
    {
      expect_valid(CP::repair_surface(points, soup.polygons), points);
    }
    catch(const std::invalid_argument&) // all faces are degenerate
    {}
  }
}

} // namespace test_repair_surface
