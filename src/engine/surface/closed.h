// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_CLOSED_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_CLOSED_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>

#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The triangles with those that close the boundary loops.
inline std::vector<Index_triangle> closed(const Surface_component_3& surface)
{
  std::vector<Index_triangle> result = surface.triangles;
  result.insert(result.end(), surface.caps.begin(), surface.caps.end());
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_CLOSED_H
