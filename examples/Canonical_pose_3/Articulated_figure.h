// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_FIGURE_H
#define CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_FIGURE_H

// A procedural person; the arms are stretched sideways in the rest pose.

#include "Articulated_shape.h"

#include <cstddef>
#include <vector>

namespace Canonical_pose_examples {

/// Angles of the joints in degrees; all are zero in the rest pose. Equal left and right angles are
/// symmetric.
struct Joint_angles
{
  struct Arm
  {
    double raise = 0;   ///< shoulder: 90 is straight up, -90 straight down
    double forward = 0; ///< shoulder, to the front
    double twist = 0;   ///< of the upper arm: at 90, the elbow bends upward, not forward
    double elbow = 0;
    double wrist = 0; ///< positive: the palm bends downward (in the rest pose)
  };
  struct Leg
  {
    double flexion = 0;   ///< hip: 90 lifts the thigh forward
    double abduction = 0; ///< hip, outward
    double knee = 0;      ///< positive: the heel moves backward
    double ankle = 0;     ///< positive: the toes move down
  };
  struct Trunk
  {
    double bend = 0; ///< to the front
    double lean = 0; ///< to the left
    double turn = 0; ///< to the left
  };
  Arm left_arm, right_arm;
  Leg left_leg, right_leg;
  Trunk spine, neck;
};

enum class Landmark { LEFT_HAND, RIGHT_HAND, LEFT_FOOT, RIGHT_FOOT, HEAD };

namespace detail {
class Person; // in Articulated_figure.cpp
}

/// A person; the arms are stretched sideways in the rest pose.
class Articulated_figure : public Articulated_shape<detail::Person, Joint_angles>
{
public:
  using Articulated_shape::Articulated_shape;

  /// Index of the vertex at a tip of the body.
  std::size_t landmark(Landmark which) const;

  /// Five poses that differ in all joints.
  static std::vector<Named_pose> named_poses();

  /// A pose in which the left palm nearly touches the left knee.
  static Joint_angles hand_on_knee();

  /// The triangles of `hand_on_knee()` with the hand merged with the knee, see `merge_contact()`.
  Triangles merged_triangles() const;
};

} // namespace Canonical_pose_examples

#endif // CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_FIGURE_H
