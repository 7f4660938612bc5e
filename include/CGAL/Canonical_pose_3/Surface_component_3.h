// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_SURFACE_COMPONENT_3_H
#define CGAL_CANONICAL_POSE_3_SURFACE_COMPONENT_3_H

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

\brief is a connected surface that gets a pose of its own: an oriented 2-manifold, perhaps with boundary.

\sa `prepare_surface()`
*/
struct Surface_component_3
{
  /// \f$ n \times 3 \f$, the points.
  Point_matrix points;

  /// triples of rows of `points`.
  std::vector<std::array<std::size_t, 3>> triangles;

  /// triangles over the same vertices that close the loops of the boundary.
  std::vector<std::array<std::size_t, 3>> caps;

  /// the face of the input that each triangle is part of.
  std::vector<std::size_t> face_of_triangle;

  /// the vertex of the input that each point is; for a tetrahedral complex, the vertex of its boundary. Where the input
  /// is not manifold, several points are the same vertex.
  std::vector<std::size_t> origins;

  /// the vertex of the input that each surface vertex of the body is: `origins`, unless the input is a complex, whose
  /// surface vertices are those of its cells.
  std::vector<std::size_t> body_origins;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SURFACE_COMPONENT_3_H
