// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_LIMB_GOALS_H
#define CANONICAL_POSE_3_ENGINE_STANCE_LIMB_GOALS_H

#include "Body_plan.h"

#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Where a limb goes: in a direction of length 1, straight or as it is. Without a direction, it keeps its pose relative to the
// trunk.
struct Limb_goal
{
  std::optional<Eigen::Vector3d> direction;
  bool is_straightened = true;
  std::optional<Eigen::Vector3d> direction_of_tip; // of a foot, if the limb is straight

  bool is_straight() const { return direction && is_straightened; }

  // Whether it is a leg that stands on the floor.
  bool stands() const { return is_straight() && direction_of_tip && direction->y() < -.9; }
};

// In the order of Body_plan::limbs().
using Limb_goals = std::array<Limb_goal, 4>;

// The name of a limb, such as "left arm".
std::string name_of_limb(Skeleton_3::Kind kind, std::size_t limb);

// Throws Limb_direction_error for a direction, an enumerator or a vertex that is not valid for any shape, or for a limb that
// occurs twice by its name. `number_of_vertices`: those to which the directions may refer.
void check_limb_directions(const std::vector<Limb_direction_3>& directions,
                           std::size_t number_of_vertices);

// `directions`: their vertices are those of the body.
// Throws std::invalid_argument if the body is not of the kind of the stance, Limb_direction_error if it lacks a limb.
Limb_goals limb_goals(const Body_plan& body, Method_options::Stance stance,
                      const std::vector<Limb_direction_3>& directions);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_LIMB_GOALS_H
