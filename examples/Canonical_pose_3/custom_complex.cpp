// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The canonical pose of a user-defined tetrahedral complex, accessed through its traits.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/canonical_pose_3.h>
#include <CGAL/property_map.h>
#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

struct My_complex
{
  std::vector<Point_3> points;
  std::vector<std::array<int, 4>> cells;
};

template <>
struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3<My_complex>
{
  using Vertex_descriptor = int;
  using Point_3 = ::Point_3;
  static auto vertices(const My_complex& c) { return boost::irange(0, int(c.points.size())); }
  static const auto& cells(const My_complex& c) { return c.cells; }
  static const Point_3& point(const My_complex& c, int v) { return c.points[v]; }
};

int main()
{
  // A bar of 16 x 2 x 3 boxes, bent to a half circle.
  My_complex bar;
  for(int v = 0; v < 17 * 3 * 4; ++v)
  {
    const double angle = 3.14 * (v / 12) / 16, radius = 4.5 + v % 4 / 3.;
    bar.points.emplace_back(radius * std::cos(angle), v / 4 % 3 / 2., radius * std::sin(angle));
  }
  std::array<int, 3> steps = {1, 4, 12}; // a box is split along the six paths from corner to corner
  do
    for(int v = 0; v < 16 * 3 * 4; ++v)
      if(v / 4 % 3 < 2 && v % 4 < 3)
        bar.cells.push_back({v, v + steps[0], v + steps[0] + steps[1], v + 1 + 4 + 12});
  while(std::next_permutation(steps.begin(), steps.end()));
  std::vector<Point_3> pose(bar.points.size());
  const auto summary = CGAL::canonical_pose_3(bar, CGAL::make_property_map(pose)).summary;
  const double length = CGAL::approximate_sqrt(CGAL::squared_distance(pose.front(), pose.back()));
  std::cout << summary << "\nfrom end to end: 10.0 -> " << length << '\n';
  return summary.is_usable() && length > 14 ? EXIT_SUCCESS : EXIT_FAILURE;
}
