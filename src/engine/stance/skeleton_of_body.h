// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_SKELETON_OF_BODY_H
#define CANONICAL_POSE_3_ENGINE_STANCE_SKELETON_OF_BODY_H

#include "Body_plan.h"

#include <CGAL/Canonical_pose_3/Skeleton_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The joints in a pose, and the weights of the vertices of the surface. `upright`: the vertices in the frame of the body, from
// which the pose may differ a little.
Skeleton_3 skeleton_of_body(const Body_plan& body, const Point_matrix& pose,
                            const Point_matrix& upright);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_SKELETON_OF_BODY_H
