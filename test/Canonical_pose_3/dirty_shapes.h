// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_DIRTY_SHAPES_H
#define CGAL_CANONICAL_POSE_3_TEST_DIRTY_SHAPES_H

// Procedural surfaces with one defect each, which is known by construction.

#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Canonical_pose_test {

using Polygons = std::vector<std::vector<std::size_t>>;

struct Polygon_soup
{
  Points points;
  Polygons polygons;
};

inline Polygon_soup to_polygons(const Triangle_soup& soup)
{
  Polygon_soup result{soup.points, {}};
  for(const auto& t : soup.triangles)
    result.polygons.emplace_back(t.begin(), t.end());
  return result;
}

/// The unit cube, six quads oriented outward.
inline Polygon_soup quad_cube()
{
  Polygon_soup soup;
  for(int v = 0; v < 8; ++v)
    soup.points.push_back({{double(v & 1), double(v >> 1 & 1), double(v >> 2)}});
  soup.polygons
    = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return soup;
}

/// The same faces, each with its own corners, as in an STL file.
inline Polygon_soup unsewn(const Polygon_soup& soup)
{
  Polygon_soup result;
  for(const auto& polygon : soup.polygons)
  {
    result.polygons.emplace_back();
    for(const std::size_t v : polygon)
    {
      result.polygons.back().push_back(result.points.size());
      result.points.push_back(soup.points[v]);
    }
  }
  return result;
}

/// Both soups, the second one moved along x.
inline Polygon_soup merged(Polygon_soup a, const Polygon_soup& b, const double shift)
{
  const std::size_t n = a.points.size();
  for(auto p : b.points)
  {
    p[0] += shift;
    a.points.push_back(p);
  }
  for(auto polygon : b.polygons)
  {
    for(std::size_t& v : polygon)
      v += n;
    a.polygons.push_back(polygon);
  }
  return a;
}

/// Replaces vertex `from` by `to`.
inline Polygon_soup renamed(Polygon_soup soup, const std::size_t from, const std::size_t to)
{
  for(auto& polygon : soup.polygons)
    for(std::size_t& v : polygon)
      v = v == from ? to : v;
  return soup;
}

/// A ball of 12 vertices and 20 faces.
inline Polygon_soup ball() { return to_polygons(icosphere_soup(0, 1.)); }

/// Two balls that share vertex 8.
inline Polygon_soup pinched_balls() { return renamed(merged(ball(), ball(), 5.), 22, 8); }

/// Two cubes that share an edge, which thus has four faces.
inline Polygon_soup cubes_with_a_common_edge()
{
  Polygon_soup soup = merged(quad_cube(), quad_cube(), 1.);
  for(std::size_t v = 8; v < 16; ++v)
    soup.points[v][1] += 1;
  return renamed(renamed(soup, 8, 3), 12, 7);
}

/// The ball and a face attached to its edge from vertex 0 to 11.
inline Polygon_soup ball_with_fin()
{
  Polygon_soup soup = ball();
  soup.points.push_back({{-3., 3., 0.}});
  soup.polygons.push_back({0, 11, 12});
  return soup;
}

/// A band of 2 n triangles over n positions around the z axis, with half a twist.
inline Polygon_soup moebius_strip(const std::size_t n)
{
  Polygon_soup soup;
  for(std::size_t i = 0; i < n; ++i)
    for(const double side : {-0.3, 0.3})
    {
      const double u = 2 * pi * double(i) / double(n);
      const double distance = 1 + side * std::cos(u / 2);
      soup.points.push_back(
        {{distance * std::cos(u), distance * std::sin(u), side * std::sin(u / 2)}});
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    soup.polygons.push_back({a, c, b});
    soup.polygons.push_back({b, c, d});
  }
  return soup;
}

/// The faces in reverse order, with vertex i renamed to n - 1 - i.
inline Polygon_soup relabeled(const Polygon_soup& soup)
{
  Polygon_soup result{{soup.points.rbegin(), soup.points.rend()},
                      {soup.polygons.rbegin(), soup.polygons.rend()}};
  for(auto& polygon : result.polygons)
    for(std::size_t& v : polygon)
      v = soup.points.size() - 1 - v;
  return result;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_DIRTY_SHAPES_H
