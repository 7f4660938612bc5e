// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_ANIMAL_H
#define CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_ANIMAL_H

// A procedural four-legged animal; it stands on straight legs in the rest pose.

#include "Articulated_shape.h"

#include <vector>

namespace Canonical_pose_examples {

/// Angles of the joints in degrees; all are zero in the rest pose. Equal left and right angles,
/// without turns, are symmetric.
struct Animal_joint_angles
{
  struct Leg
  {
    double flexion = 0; ///< shoulder or hip: 90 lifts the leg forward
    double spread = 0;  ///< shoulder or hip, outward
    double knee = 0;    ///< positive: the shank moves backward; of a foreleg: forward
    double hock = 0;    ///< positive: the foot moves forward; of a foreleg (the wrist): backward
    double paw = 0;     ///< positive: the toes move down
  };
  struct Part
  {
    double bend = 0; ///< positive: the far end moves down
    double turn = 0; ///< positive: the far end moves to the left
  };
  Leg left_foreleg, right_foreleg, left_hind_leg, right_hind_leg;
  Part trunk; ///< of the entire animal, without bending
  Part spine, neck, head, tail, tip_of_tail;
};

namespace detail {
class Quadruped; // in Articulated_animal.cpp
}

/// A four-legged animal; its legs are straight in the rest pose.
class Articulated_animal : public Articulated_shape<detail::Quadruped, Animal_joint_angles>
{
public:
  using Articulated_shape::Articulated_shape;

  /// Three poses that differ in most joints.
  static std::vector<Named_pose> named_poses();
};

} // namespace Canonical_pose_examples

#endif // CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_ANIMAL_H
