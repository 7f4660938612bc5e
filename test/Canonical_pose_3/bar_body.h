// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_BAR_BODY_H
#define CGAL_CANONICAL_POSE_3_TEST_BAR_BODY_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>

#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace Canonical_pose_test {

/// the points of `tetrahedral_bent_bar()`
inline Point_matrix bar_points(std::size_t nx, std::size_t ny, std::size_t nz, double angle)
{
  return to_matrix(tetrahedral_bent_bar(nx, ny, nz, angle).points);
}

/// tetrahedra as a body, all of whose vertices are surface vertices
inline CGAL::Canonical_pose_3::Conforming_body_3 to_body(const Tetrahedral_soup& soup)
{
  std::vector<std::array<int, 4>> cells;
  for(const auto& c : soup.cells)
    cells.push_back({int(c[0]), int(c[1]), int(c[2]), int(c[3])});
  return CGAL::Canonical_pose_3::Conforming_body_3(to_matrix(soup.points), cells,
                                                   soup.points.size());
}

/// the bar as such a body
inline CGAL::Canonical_pose_3::Conforming_body_3 bar_body(std::size_t nx, std::size_t ny,
                                                          std::size_t nz, double angle = 0)
{
  return to_body(tetrahedral_bent_bar(nx, ny, nz, angle));
}

/// iterates until nothing moves any more; inverted cells remain, so that the result is a minimum
inline CGAL::Canonical_pose_3::Registration_options to_the_end()
{
  CGAL::Canonical_pose_3::Registration_options options;
  options.injective = false;
  options.number_of_iterations = 5000;
  options.energy_tolerance = 1e-14;
  options.move_tolerance = 1e-10;
  return options;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_BAR_BODY_H
