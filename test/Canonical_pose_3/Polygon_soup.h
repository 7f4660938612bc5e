// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_POLYGON_SOUP_H
#define CGAL_CANONICAL_POSE_3_TEST_POLYGON_SOUP_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include "shapes.h"

#include <cstddef>
#include <vector>

namespace Canonical_pose_test {

struct Polygon_soup
{
  CGAL::Canonical_pose_3::Point_matrix points;
  std::vector<std::vector<std::size_t>> polygons;
};

inline Polygon_soup polygon_soup(const Triangle_soup& soup)
{
  Polygon_soup result;
  result.points.resize(static_cast<Eigen::Index>(soup.points.size()), 3);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    result.points.row(static_cast<Eigen::Index>(v)) << soup.points[v][0], soup.points[v][1],
      soup.points[v][2];
  for(const auto& t : soup.triangles)
    result.polygons.push_back({t[0], t[1], t[2]});
  return result;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_POLYGON_SOUP_H
