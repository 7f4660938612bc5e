// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_VERTEX_COMBINATION_3_H
#define CGAL_CANONICAL_POSE_3_VERTEX_COMBINATION_3_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief represents a vertex of a surface as a combination of three others.

\sa `Coarse_surface_3`, `Surface_component_3::added`
*/
struct Vertex_combination_3
{
  std::size_t vertex;                  ///< the vertex.
  std::array<std::size_t, 3> vertices; ///< the three others.
  std::array<double, 3> weights;       ///< nonnegative, with sum 1.
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_VERTEX_COMBINATION_3_H
