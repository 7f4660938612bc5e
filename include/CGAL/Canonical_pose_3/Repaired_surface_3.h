// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_REPAIRED_SURFACE_3_H
#define CGAL_CANONICAL_POSE_3_REPAIRED_SURFACE_3_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an oriented 2-manifold created by `repair_surface()` from any polygons, with the
correspondence between its elements and those of the input.

No point is moved or added: each vertex is a copy of a vertex of the input.

\sa `repair_surface()`, `component_of_surface()`
*/
struct Repaired_surface_3
{
  /// \f$ n \times 3 \f$, positions: row `i` is row `origins[i]` of the input.
  Point_matrix points;
  /// triples of rows of `points`, an oriented 2-manifold, possibly with boundary. Each row belongs
  /// to at least one triangle. The rows of a triangle are distinct, but its area may be zero. Each
  /// component is oriented outward: the volume enclosed by it and its caps is not negative.
  std::vector<std::array<std::size_t, 3>> triangles;
  /// row of the input of each vertex. Where the input is not manifold, several vertices have the
  /// same row.
  std::vector<std::size_t> origins;
  /// for each row of the input, the row whose copies represent it: itself, unless it was stitched
  /// to another row at the same position.
  std::vector<std::size_t> representatives;
  /// face of the input to which each triangle belongs.
  std::vector<std::size_t> face_of_triangle;
  /// triangles with the same vertices that close the boundary loops: `triangles` and `caps`
  /// together traverse each edge equally often in both directions.
  std::vector<std::array<std::size_t, 3>> caps;
  /// component of each triangle; components are connected by edges and sorted by decreasing area.
  std::vector<std::size_t> component_of_triangle;
  /// number of components.
  std::size_t number_of_components = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REPAIRED_SURFACE_3_H
