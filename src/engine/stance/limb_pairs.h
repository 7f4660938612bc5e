// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_LIMB_PAIRS_H
#define CANONICAL_POSE_3_ENGINE_STANCE_LIMB_PAIRS_H

#include "extremities.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Which extremities are limbs of both sides, and which are head and tail.
struct Limb_pairs
{
  std::array<std::size_t, 2> arms, legs; // arms are nearer to the head
  std::size_t head;
};

// Extremities are reduced to those of limbs. `distances`: one row per vertex and one column per extremity, by the root of the
// area; `shares`: of the vertices in the area.
Limb_pairs limb_pairs(const std::vector<Extremity>& limbs, const std::vector<Extremity>& details,
                      const Eigen::MatrixXd& distances, const Eigen::VectorXd& shares);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_LIMB_PAIRS_H
