// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_LINKED_BODIES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_LINKED_BODIES_H

#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_MESH_3
#include <CGAL/Canonical_pose_3/mesh_3_body.h>
#endif
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#endif

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
inline namespace CGAL_CANONICAL_POSE_3_BODIES {

// The bodies with which this translation unit is compiled.
inline Body_makers linked_bodies()
{
  Body_makers makers;
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
  makers.tetgen = tetgen_body_of_clean_surface;
#endif
#ifdef CGAL_CANONICAL_POSE_3_USE_MESH_3
  makers.mesh_3 = [](const Point_matrix& points, const std::vector<Index_triangle>& triangles,
                     const double length_scale, const double cell_size) {
    return mesh_3_body_of_clean_surface(points, triangles, length_scale,
                                        cell_size > 0 ? cell_size : MESH_3_CELL_SIZE);
  };
#endif
  return makers;
}

} // namespace CGAL_CANONICAL_POSE_3_BODIES
} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_LINKED_BODIES_H
