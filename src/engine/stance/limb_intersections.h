// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_LIMB_INTERSECTIONS_H
#define CANONICAL_POSE_3_ENGINE_STANCE_LIMB_INTERSECTIONS_H

#include "Body_plan.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The pairs of limbs whose surfaces intersect in a pose, away from their joints; 4 is the trunk with all that is not a limb.
std::vector<std::pair<std::size_t, std::size_t>>
limb_intersections(const Body_plan& body, const Point_matrix& pose,
                   const std::vector<std::array<std::size_t, 3>>& triangles);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_LIMB_INTERSECTIONS_H
