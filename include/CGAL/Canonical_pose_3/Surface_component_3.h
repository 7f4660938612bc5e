// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SURFACE_COMPONENT_3_H
#define CGAL_CANONICAL_POSE_3_SURFACE_COMPONENT_3_H

#include <CGAL/Canonical_pose_3/Vertex_combination_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a connected component of the input, an oriented 2-manifold with or without boundary.

\sa `prepare_surface()`
*/
struct Surface_component_3
{
  /// \f$ n \times 3 \f$, the points.
  Point_matrix points;

  /// triples of rows of `points`.
  std::vector<std::array<std::size_t, 3>> triangles;

  /// triangles with the same vertices that close the boundary loops.
  std::vector<std::array<std::size_t, 3>> caps;

  /// the face of the input to which each triangle belongs.
  std::vector<std::size_t> face_of_triangle;

  /// the vertex of the input that each point is a copy of; for a tetrahedral complex, the vertex of
  /// its boundary. Where the input is not manifold, several points are copies of the same vertex.
  /// The points of `added` follow after these, and are not copies of a vertex.
  std::vector<std::size_t> origins;

  /// the vertex of the input that each surface vertex of the body is a copy of. The same as
  /// `origins`, except for a complex, where all vertices are surface vertices.
  std::vector<std::size_t> body_origins;

  /// points that `prepare_surface()` added because the triangles are too large to measure distances at
  /// their vertices alone: each is a combination of points before it. They do not change the shape.
  std::vector<Vertex_combination_3> added;

  /// for each false contact that was cut, a vertex of the input on the curve; see `cut_contacts()`.
  std::vector<std::size_t> contacts;

  /// the number of cells of its body, relative to that of a single component: several components
  /// share it by area, see `Options::components`. In \f$ (0, 1] \f$.
  double share_of_cells = 1;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SURFACE_COMPONENT_3_H
