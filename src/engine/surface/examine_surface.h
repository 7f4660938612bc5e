// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_EXAMINE_SURFACE_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_EXAMINE_SURFACE_H

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

struct Examined_surface
{
  Diagnosis_3 diagnosis;
  Repaired_surface_3 surface;
};

// diagnose() and repair_surface() combined: their results, and their exceptions in this order.
Examined_surface examine_surface(const Point_matrix& points, const Face_list& polygons,
                                 bool searches_self_intersections);

// diagnose() for the boundary of a complex.
Diagnosis_3 examine_boundary(const Point_matrix& points,
                             const std::vector<std::array<std::size_t, 4>>& cells,
                             bool searches_self_intersections);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_EXAMINE_SURFACE_H
