// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_STANCE_TARGET_H
#define CANONICAL_POSE_3_ENGINE_STANCE_STANCE_TARGET_H

#include "Body_plan.h"
#include "limb_goals.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Where the vertices of a body are in a stance, in the frame of the body: trunk and limbs move rigidly, and a vertex near a joint
// has no target.
struct Stance_target
{
  Point_matrix points;
  Eigen::VectorXd weights;                   // 1 or 0
  std::array<Eigen::Vector3d, 4> directions; // of the limbs
};

// From a limb's upper part to wrist or ankle, if the vertices of the body are at `points`.
Eigen::Vector3d direction_of_limb(const Body_plan& body, const Limb& limb,
                                  const Point_matrix& points);

// `stance`: what the trunk of an animal does.
Stance_target stance_target(const Body_plan& body, Method_options::Stance stance,
                            const Limb_goals& goals);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_STANCE_TARGET_H
