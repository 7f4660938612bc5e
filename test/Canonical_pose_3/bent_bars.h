// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_BENT_BARS_H
#define CGAL_CANONICAL_POSE_3_TEST_BENT_BARS_H

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>

#include "dirty_shapes.h"
#include "matchers.h"
#include "shapes.h"

#include <cstddef>
#include <vector>

namespace Canonical_pose_test {

using CGAL::Canonical_pose_3::Result;

template <class Polygons>
Result pose_of(const Points& points, const Polygons& polygons,
               const CGAL::Canonical_pose_3::Options& options)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> input, pose;
  for(const auto& p : points)
    input.emplace_back(p[0], p[1], p[2]);
  const Result result = CGAL::canonical_pose_3(input, polygons, pose, options);
  EXPECT_EQ(to_matrix(pose), result.pose);
  return result;
}

inline Result pose_of(const Triangle_soup& soup, const CGAL::Canonical_pose_3::Options& options)
{
  return pose_of(soup.points, soup.triangles, options);
}

inline Result pose_of(const Polygon_soup& soup, const CGAL::Canonical_pose_3::Options& options)
{
  return pose_of(soup.points, soup.polygons, options);
}

/// a bent bar, so fine that it is not refined
inline Triangle_soup bent_bar() { return boundary(tetrahedral_bent_bar(48, 6, 6, 2.)); }

/// two bent bars, far from each other
inline Triangle_soup two_bars()
{
  Triangle_soup soup = bent_bar();
  const std::size_t n = soup.points.size(), f = soup.triangles.size();
  for(std::size_t i = 0; i < n; ++i)
    soup.points.push_back({soup.points[i][0], soup.points[i][1] + 1, soup.points[i][2] + 20});
  for(std::size_t t = 0; t < f; ++t)
    soup.triangles.push_back(
      {soup.triangles[t][0] + n, soup.triangles[t][1] + n, soup.triangles[t][2] + n});
  return soup;
}

inline Polygon_soup bar() { return to_polygons(bent_bar()); }

/// a bar of half the size
inline Polygon_soup small_bar()
{
  return to_polygons(boundary(tetrahedral_bent_bar(56, 6, 6, 2., {{4., .5, .5}})));
}

/// a soup with that many isolated vertices in front
inline Polygon_soup with_isolated_vertices(const Polygon_soup& soup, const std::size_t number)
{
  Polygon_soup result;
  for(std::size_t i = 0; i < number; ++i)
    result.points.push_back({{0.01 * double(i), 0.3, 0.2}});
  result.points.insert(result.points.end(), soup.points.begin(), soup.points.end());
  result.polygons = soup.polygons;
  for(auto& polygon : result.polygons)
    for(std::size_t& v : polygon)
      v += number;
  return result;
}

inline CGAL::Canonical_pose_3::Options each_component()
{
  CGAL::Canonical_pose_3::Options options;
  options.components = CGAL::Canonical_pose_3::Options::Components::EACH;
  return options;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_BENT_BARS_H
