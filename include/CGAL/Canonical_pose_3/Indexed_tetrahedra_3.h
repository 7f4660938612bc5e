// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INDEXED_TETRAHEDRA_3_H
#define CGAL_CANONICAL_POSE_3_INDEXED_TETRAHEDRA_3_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a tetrahedral complex given by an array of points and an array of cells.

\tparam Point a point type of a kernel, or of a model of `CanonicalPoseTraits_3`

\sa `Tetrahedral_complex_traits_3`
\sa `Labeled_cells_3`
*/
template <class Point>
struct Indexed_tetrahedra_3
{
  /// the type of points.
  using Point_3 = Point;

  /// the points; isolated points are allowed, but belong to no body and are refused where they
  /// would matter.
  std::vector<Point> points;

  /// four indices into `points` per cell, in either orientation.
  std::vector<std::array<std::size_t, 4>> cells;

  /// one label per cell, or none; used only by `Labeled_cells_3`, which refuses any other number.
  std::vector<int> labels{};
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INDEXED_TETRAHEDRA_3_H
