// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TEST_CONFORMING_BAR_H
#define CGAL_CANONICAL_POSE_3_TEST_CONFORMING_BAR_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>

#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace Canonical_pose_test {

/// a bar of `nx` times 2 times 2 boxes, 8 long and 1 thick, bent by an angle
inline CGAL::Canonical_pose_3::Conforming_body_3 conforming_bar(const double angle,
                                                                const std::size_t nx = 12)
{
  const Tetrahedral_soup soup = tetrahedral_bent_bar(nx, 2, 2, angle);
  std::vector<std::array<int, 4>> cells;
  for(const auto& c : soup.cells)
    cells.push_back({int(c[0]), int(c[1]), int(c[2]), int(c[3])});
  return CGAL::Canonical_pose_3::Conforming_body_3(to_matrix(soup.points), cells,
                                                   soup.points.size());
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_CONFORMING_BAR_H
