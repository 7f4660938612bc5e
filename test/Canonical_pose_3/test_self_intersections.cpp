// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/surface/Self_intersections.h"

#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include "dirty_shapes.h"
#include "matchers.h"
#include "threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace test_self_intersections {

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

using Face_pair = CP::internal::Self_intersections::Face_pair;
using Face_pairs = std::vector<Face_pair>;

Face_pairs pairs(const Polygon_soup& soup, const std::size_t maximum)
{
  const CP::Point_matrix points = to_matrix(soup.points);
  const auto triangles = CP::internal::triangle_soup(points, soup.polygons);
  return CP::internal::Self_intersections(points, triangles).run(maximum).value();
}

Face_pairs all_pairs(const Polygon_soup& soup)
{
  return pairs(soup, (std::numeric_limits<std::size_t>::max)());
}

// The same, computed by CGAL.
Face_pairs expected_pairs(const Polygon_soup& soup)
{
  using Mesh = CP::internal::Indexed_mesh;
  std::vector<CP::internal::Index_triangle> triangles;
  for(const auto& p : soup.polygons)
    triangles.push_back({p[0], p[1], p[2]});
  const Mesh mesh = CP::internal::indexed_mesh(to_matrix(soup.points), triangles);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  Face_pairs result;
  for(const auto& [f, g] : found)
    result.push_back(std::minmax<std::size_t>({f, g}));
  std::sort(result.begin(), result.end());
  return result;
}

Polygon_soup two_balls()
{
  const Polygon_soup ball = to_polygons(icosphere_soup(5, 1.));
  return merged(ball, ball, 0.5);
}

// All neighbors are coplanar.
Polygon_soup two_sheets()
{
  const Polygon_soup sheet = to_polygons(plane_grid_soup(100, 100, 1., 1.));
  Polygon_soup standing = sheet;
  for(auto& p : standing.points)
    p = {{p[0], 0.503, p[1] - 0.5}};
  return merged(sheet, standing, 0.2);
}

// Neighbors along the fold coincide.
Polygon_soup folded_sheet()
{
  Polygon_soup sheet = to_polygons(plane_grid_soup(20, 20, 1., 1.));
  for(auto& p : sheet.points)
    p[0] = std::abs(p[0] - 0.5);
  return sheet;
}

TEST(Self_intersections, are_those_that_polygon_mesh_processing_finds)
{
  for(const Polygon_soup& soup : {two_balls(), two_sheets(), folded_sheet()})
  {
    const Face_pairs expected = expected_pairs(soup);
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(all_pairs(soup), expected);
  }
}

// All of them, and the first ones if there are too many.
TEST(Self_intersections, number_of_threads_does_not_matter)
{
  for(const Polygon_soup& soup : {two_balls(), two_sheets(), folded_sheet()})
  {
    const Face_pairs all = all_pairs(soup), first = pairs(soup, 10);
    with_each_number_of_threads([&] {
      EXPECT_EQ(all_pairs(soup), all);
      EXPECT_EQ(pairs(soup, 10), first);
    });
  }
}

TEST(Self_intersections, where_there_are_too_many_some_are_found)
{
  const Polygon_soup soup = two_balls();
  const Face_pairs all = all_pairs(soup), first = pairs(soup, 10);
  EXPECT_EQ(first.size(), 10u);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), first.begin(), first.end()));
  EXPECT_EQ(pairs(soup, all.size() + 1), all);
}

// The bounding boxes of n parallel triangles all overlap, but no two triangles intersect.
TEST(Self_intersections, search_is_given_up_where_too_many_boxes_overlap)
{
  constexpr std::size_t n = 1000, overlaps = n * (n - 1) / 2;
  Polygon_soup soup;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = 1. + double(i) / n;
    soup.points.push_back({{x, 0., 0.}});
    soup.points.push_back({{0., x, 0.}});
    soup.points.push_back({{0., 0., x}});
    soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const CP::Point_matrix points = to_matrix(soup.points);
  const auto triangles = CP::internal::triangle_soup(points, soup.polygons);
  CP::internal::Self_intersections search(points, triangles);
  EXPECT_FALSE(search.run(1000, overlaps / 2 - 200 * n));
  const auto found = search.run(1000, overlaps);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->empty());
}

} // namespace test_self_intersections
