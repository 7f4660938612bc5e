// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_LIMB_INTERSECTIONS_H
#define CANONICAL_POSE_3_ENGINE_STANCE_LIMB_INTERSECTIONS_H

#include "Body_plan.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The pairs of limbs that intersect in a pose, away from their own joints; 4 is the trunk with all that is not a limb, or an unknown part.
// `triangles`: of the surface, of which `coarse` has some of the vertices.
std::vector<std::pair<std::size_t, std::size_t>>
limb_intersections(const Body_plan& body, const Coarse_surface_3& coarse, const Point_matrix& pose,
                   const std::vector<std::array<std::size_t, 3>>& triangles);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_LIMB_INTERSECTIONS_H
