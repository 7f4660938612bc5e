// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_CORNERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_CORNERS_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The corners of the faces around each vertex, that is, the halfedges with this origin. Their
// `next` and `previous` halfedges lead to all its neighbors, including those at the border.
inline Buckets<int> vertex_corners(const Intrinsic_triangulation& triangulation)
{
  return Buckets<int>(triangulation.number_of_vertices(), [&](const auto& put) {
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
      put(static_cast<std::size_t>(triangulation.origin(h)), h);
  });
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_CORNERS_H
