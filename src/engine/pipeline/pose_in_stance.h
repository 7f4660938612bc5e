// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_POSE_IN_STANCE_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_POSE_IN_STANCE_H

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The stance of the options and the skeleton of a surface. `canonical`: its canonical pose.
Result pose_in_stance(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                      const Surface_body_3& body, const Component_options& options,
                      Result canonical);

// A skeleton whose weights are those of other points: of the nearest ones. Both are in the pose.
Skeleton_3 with_weights_at(const Point_matrix& others, const Point_matrix& points,
                           Skeleton_3 skeleton);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_POSE_IN_STANCE_H
