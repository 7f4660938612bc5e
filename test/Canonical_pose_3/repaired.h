// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_REPAIRED_H
#define CGAL_CANONICAL_POSE_3_TEST_REPAIRED_H

#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <gtest/gtest.h>

#include "dirty_shapes.h"
#include "matchers.h"

#include <Eigen/Dense>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Canonical_pose_test {

/// The volume enclosed by triangles and caps.
inline double volume(const CGAL::Canonical_pose_3::Repaired_surface_3& surface)
{
  double result = 0;
  for(const auto* triangles : {&surface.triangles, &surface.caps})
    for(const auto& t : *triangles)
      result
        += surface.points.row(t[0]).dot(surface.points.row(t[1]).cross(surface.points.row(t[2])))
           / 6;
  return result;
}

/// Guarantees of the documentation for any input.
inline void expect_valid(const CGAL::Canonical_pose_3::Repaired_surface_3& surface,
                         const Point_matrix& points)
{
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  std::vector<bool> is_used(surface.origins.size(), false);
  for(const auto& t : surface.triangles)
    for(int k = 0; k < 3; ++k)
    {
      is_used.at(t[k]) = true;
      EXPECT_NE(t[k], t[(k + 1) % 3]);
      EXPECT_EQ((++sides[{t[k], t[(k + 1) % 3]}]), 1);
    }
  EXPECT_EQ(is_used, std::vector<bool>(surface.origins.size(), true));
  EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(surface.triangles));
  for(const auto& t : surface.caps)
    for(int k = 0; k < 3; ++k)
      ++sides[{t[k], t[(k + 1) % 3]}];
  for(const auto& side : sides)
    EXPECT_EQ((sides[{side.first.second, side.first.first}]), side.second);
  for(std::size_t v = 0; v < surface.origins.size(); ++v)
  {
    EXPECT_EQ(surface.points.row(v), points.row(surface.origins[v]));
    EXPECT_EQ(surface.representatives[surface.origins[v]], surface.origins[v]);
  }
  std::vector<double> areas(surface.number_of_components, 0);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    areas.at(surface.component_of_triangle[t]) += 1;
  for(const double area : areas)
    EXPECT_GT(area, 0);
}

/// The repaired surface, after checking the guarantees.
inline CGAL::Canonical_pose_3::Repaired_surface_3 repaired(const Polygon_soup& soup)
{
  const Point_matrix points = to_matrix(soup.points);
  const CGAL::Canonical_pose_3::Repaired_surface_3 result
    = CGAL::Canonical_pose_3::repair_surface(points, soup.polygons);
  expect_valid(result, points);
  for(std::size_t c = 0; c < result.number_of_components; ++c)
    expect_valid(CGAL::Canonical_pose_3::component_of_surface(result, c), points);
  const CGAL::Canonical_pose_3::Repaired_surface_3 other = CGAL::Canonical_pose_3::repair_surface(
    to_matrix(relabeled(soup).points), relabeled(soup).polygons);
  EXPECT_EQ(other.triangles.size(), result.triangles.size());
  EXPECT_EQ(other.origins.size(), result.origins.size());
  EXPECT_EQ(other.caps.size(), result.caps.size());
  EXPECT_EQ(other.number_of_components, result.number_of_components);
  return result;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_REPAIRED_H
