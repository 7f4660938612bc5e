// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_REPAIRED_SURFACE_3_H
#define CGAL_CANONICAL_POSE_3_REPAIRED_SURFACE_3_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an oriented 2-manifold that says where its vertices come from, made by `repair_surface()`
out of any polygons.

No vertex is ever moved or made: each is a copy of a vertex of the input.

\sa `repair_surface()`, `component_of_surface()`
*/
struct Repaired_surface_3
{
  /// \f$ n \times 3 \f$, positions: row `i` is row `origins[i]` of the input.
  Point_matrix points;
  /// triples of rows of `points`, an oriented 2-manifold, possibly with boundary. Each row is in one
  /// at least, and no triangle names a row twice; it may have no area, though. Each component is
  /// oriented outwards: the volume that it encloses together with its caps is not negative.
  std::vector<std::array<std::size_t, 3>> triangles;
  /// row of the input of each vertex. Where the input is not manifold, several vertices have the
  /// same.
  std::vector<std::size_t> origins;
  /// for each row of the input the row whose copies stand for it: itself, unless it was sewn to
  /// another one at the same place.
  std::vector<std::size_t> representatives;
  /// face of the input that each triangle is, or is part of.
  std::vector<std::size_t> face_of_triangle;
  /// triangles over the same vertices that close the loops of the boundary: `triangles` and `caps`
  /// together run through each edge as often in one direction as in the other.
  std::vector<std::array<std::size_t, 3>> caps;
  /// component of each triangle, from 0 by decreasing area; triangles of one are connected by edges.
  std::vector<std::size_t> component_of_triangle;
  /// number of components.
  std::size_t number_of_components = 0;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REPAIRED_SURFACE_3_H
