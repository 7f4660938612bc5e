// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_BODY_MAKERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_BODY_MAKERS_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Creates bodies of clean surfaces with libraries to which not every program is linked; null in
// programs without them.
struct Body_makers
{
  Conforming_body_3 (*tetgen)(const Point_matrix& points,
                              const std::vector<Index_triangle>& triangles)
    = nullptr;

  // `cell_size`: fraction of `length_scale`; 0 for the default.
  Embedded_body_3 (*mesh_3)(const Point_matrix& points,
                            const std::vector<Index_triangle>& triangles, double length_scale,
                            double cell_size)
    = nullptr;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_BODY_MAKERS_H
