// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_DESCRIPTORS_DESCRIBED_SURFACE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_DESCRIPTORS_DESCRIBED_SURFACE_H

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The repaired surface. Every triangle starts at its smallest row, so that meshes of different types
// yield the same bytes.
inline Repaired_surface_3 described_surface(const Point_matrix& points,
                                            const std::vector<std::vector<std::size_t>>& polygons)
{
  Repaired_surface_3 result = repair_surface(points, polygons);
  for(auto& t : result.triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_DESCRIPTORS_DESCRIBED_SURFACE_H
