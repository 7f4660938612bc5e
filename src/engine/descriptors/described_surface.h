// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_DESCRIPTORS_DESCRIBED_SURFACE_H
#define CANONICAL_POSE_3_ENGINE_DESCRIPTORS_DESCRIBED_SURFACE_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The repaired surface. Every triangle starts at its smallest row, so that meshes of different types
// yield the same bytes.
inline Repaired_surface_3 described_surface(const Point_matrix& points, const Face_list& polygons)
{
  Repaired_surface_3 result = repair_surface(points, polygons);
  for(auto& t : result.triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_DESCRIPTORS_DESCRIBED_SURFACE_H
