// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Anatomy.h"
#include "Articulated_animal.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Canonical_pose_examples {

namespace detail {

/// Bends the animal along rods through legs, neck, tail and spine.
class Quadruped
{
public:
  using Joint_angles = Animal_joint_angles;

  explicit Quadruped(const Joint_angles& a)
    : forelegs(leg_rod(a.right_foreleg, true), leg_rod(a.left_foreleg, true)),
      hind_legs(leg_rod(a.right_hind_leg, false), leg_rod(a.left_hind_leg, false)),
      neck(shoulders(), neck_direction(), 0.6,
           {{0.11, 0.11, rotation(a.neck, 1)}, {0.34, 0.08, rotation(a.head, 1)}}),
      tail(Vector(0, 0.76, TAIL), -Vector::UnitZ(), 0.6,
           {{0.12, 0.10, rotation(a.tail, -1)}, {0.34, 0.12, rotation(a.tip_of_tail, -1)}}),
      spine(Vector(0, 0.7, LOIN), Vector::UnitZ(), 1.2, {{0.21, 0.21, rotation(a.spine, 1)}}),
      trunk(rotation(a.trunk, 1))
  {}

  Vector operator()(const Vector& p) const
  {
    const bool is_front = p.z() > (FORELEG + HIND_LEG) / 2;
    const double z = is_front ? FORELEG : HIND_LEG, depth = HIP - p.y();
    // Far from its axis, a leg starts farther down, so that belly and chest do not move.
    const double off_axis = std::hypot(std::abs(p.x()) - SIDE, p.z() - z);
    const double s = depth > 0.4 ? depth : depth - 1.2 * (std::max)(0., off_axis - 0.08);
    Vector q = (is_front ? forelegs : hind_legs)(s, p);
    q = neck((p - shoulders()).dot(neck_direction()), q);
    q = tail(TAIL - p.z(), q);
    return trunk * spine(p.z() - LOIN, q);
  }

  /// Negative inside the rest pose.
  static double rest_shape(Vector p)
  {
    p.x() = std::sqrt(p.x() * p.x() + 2.5e-5); // rounds the crease at the plane of symmetry
    double f = smooth_minimum(body(p), neck_and_head(p), 0.05);
    f = smooth_minimum(f, leg(p, FORELEG), 0.06);
    f = smooth_minimum(f, smooth_minimum(leg(p, HIND_LEG), haunch(p), 0.04), 0.06);
    return -smooth_minimum(-f, p.y(), 0.015); // soles
  }

  /// Suitable relative edge length around `p`: smaller where there is detail.
  static double suitable_length(const Vector& p)
  {
    const double head = smoothstep(0.5, 0.58, p.z());
    const double paws = 1 - smoothstep(0.08, 0.14, p.y());
    const double tail = 1 - smoothstep(-0.66, -0.56, p.z());
    return 1 - 0.45 * (std::max)({head, paws, 0.6 * tail});
  }

private:
  static constexpr double SIDE = 0.13, HIP = 0.75;                                      // x, y
  static constexpr double FORELEG = 0.28, HIND_LEG = -0.42, TAIL = -0.52, LOIN = -0.26; // z
  Pair_of_rods forelegs, hind_legs;
  Rod neck, tail, spine;
  Eigen::AngleAxisd trunk;

  static Vector shoulders() { return Vector(0, 0.74, 0.30); }

  static Vector neck_direction() { return Vector(0, 0.6, 0.8); }

  static double body(const Vector& p)
  {
    double f = ellipsoid(p, {0, 0.70, -0.36}, {0.14, 0.14, 0.17});
    f = smooth_minimum(f, ellipsoid(p, {0, 0.70, -0.08}, {0.14, 0.135, 0.29}), 0.08);
    f = smooth_minimum(f, ellipsoid(p, {0, 0.685, 0.2}, {0.15, 0.165, 0.22}), 0.08);
    return smooth_minimum(f, capsule(p, {0, 0.76, -0.48}, {0, 0.76, -0.98}, 0.045, 0.022), 0.04);
  }

  static double neck_and_head(const Vector& p)
  {
    double f = capsule(p, {0, 0.73, 0.28}, {0, 0.95, 0.57}, 0.105, 0.07);
    f = smooth_minimum(f, ellipsoid(p, {0, 0.98, 0.62}, {0.078, 0.078, 0.1}), 0.04);
    f = smooth_minimum(f, capsule(p, {0, 0.955, 0.68}, {0, 0.925, 0.80}, 0.05, 0.038), 0.04);
    f = smooth_minimum(f, ellipsoid(p, {0, 0.945, 0.835}, {0.022, 0.018, 0.016}), 0.01);  // nose
    f = smooth_minimum(f, ellipsoid(p, {0.045, 1.015, 0.69}, {0.02, 0.018, 0.02}), 0.02); // brow
    const double ear = capsule(p, {0.048, 1.03, 0.59}, {0.08, 1.13, 0.575}, 0.034, 0.014);
    return smooth_minimum(f, ear, 0.02);
  }

  static double leg(Vector p, double z)
  {
    p.z() -= z;
    double f = capsule(p, {SIDE - 0.015, 0.64, 0}, {SIDE, 0.40, 0}, 0.075, 0.05);
    f = smooth_minimum(f, capsule(p, {SIDE, 0.40, 0}, {SIDE, 0.17, 0}, 0.05, 0.035), 0.03);
    f = smooth_minimum(f, capsule(p, {SIDE, 0.17, 0}, {SIDE, 0.06, 0.005}, 0.035, 0.033), 0.03);
    f = smooth_minimum(f, capsule(p, {SIDE, 0.04, 0}, {SIDE, 0.04, 0.06}, 0.042, 0.038), 0.02);
    for(double x : {-0.026, 0., 0.026})
    {
      const Vector tip(SIDE + 1.2 * x, 0.026, 0.115 - 0.4 * std::abs(x));
      f = smooth_minimum(f, capsule(p, {SIDE + x, 0.03, 0.07}, tip, 0.022, 0.018), 0.008); // toe
    }
    return f;
  }

  static double haunch(const Vector& p)
  {
    const double f = ellipsoid(p, {SIDE - 0.02, 0.60, HIND_LEG}, {0.072, 0.15, 0.115});
    const double heel = ellipsoid(p, {SIDE, 0.19, HIND_LEG - 0.03}, {0.026, 0.04, 0.022});
    return smooth_minimum(f, heel, 0.02);
  }

  /// `forward`: 1 if the far end of the part is in front, -1 if it is behind.
  static Eigen::AngleAxisd rotation(const Joint_angles::Part& a, int forward)
  {
    return Eigen::AngleAxisd(about(Vector::UnitY(), forward * a.turn)
                             * about(Vector::UnitX(), forward * a.bend));
  }

  static Rod leg_rod(const Joint_angles::Leg& a, bool is_foreleg)
  {
    const int backward = is_foreleg ? -1 : 1;
    const Eigen::AngleAxisd hip(about(Vector::UnitZ(), a.spread)
                                * about(Vector::UnitX(), -a.flexion));
    return Rod(Vector(SIDE, HIP, is_foreleg ? FORELEG : HIND_LEG), -Vector::UnitY(), 0.8,
               {{0.13, 0.13, hip},
                {0.35, 0.12, about(Vector::UnitX(), backward * a.knee)},
                {0.58, 0.07, about(Vector::UnitX(), -backward * a.hock)},
                {0.675, 0.035, about(Vector::UnitX(), a.paw)}});
  }
};

} // namespace detail

template class Articulated_shape<detail::Quadruped, Animal_joint_angles>;

std::vector<Articulated_animal::Named_pose> Articulated_animal::named_poses()
{
  std::vector<Named_pose> poses(3);
  poses[0].name = "standing";
  poses[0].angles.left_foreleg = poses[0].angles.right_foreleg = {-16, 0, 26, 8, -2};
  poses[0].angles.left_hind_leg = poses[0].angles.right_hind_leg = {20, 0, 42, 32, 10};
  poses[0].angles.neck = {-15, 0};
  poses[0].angles.head = {30, 0};
  poses[0].angles.tail = {50, 0};
  poses[0].angles.tip_of_tail = {-35, 0};

  poses[1].name = "sitting";
  poses[1].angles.trunk = {-36, 0};
  poses[1].angles.spine = {12, 0};
  poses[1].angles.left_foreleg = poses[1].angles.right_foreleg = {-30, 0, 8, 0, 0};
  poses[1].angles.left_hind_leg = poses[1].angles.right_hind_leg = {54, 12, 130, 100, 57};
  poses[1].angles.neck = {5, 0};
  poses[1].angles.head = {30, 25};
  poses[1].angles.tail = {-40, 15};
  poses[1].angles.tip_of_tail = {0, 60};

  poses[2].name = "galloping";
  poses[2].angles.trunk = {-8, 0};
  poses[2].angles.left_foreleg = {48, 0, 10, 25, 0};
  poses[2].angles.right_foreleg = {10, 0, 95, 75, 0};
  poses[2].angles.left_hind_leg = {45, 4, 85, 60, 0};
  poses[2].angles.right_hind_leg = {-38, 0, 30, 25, 30};
  poses[2].angles.spine = {16, 0};
  poses[2].angles.neck = {0, 8};
  poses[2].angles.head = {22, 0};
  poses[2].angles.tail = {-25, 0};
  poses[2].angles.tip_of_tail = {40, 0};
  return poses;
}

} // namespace Canonical_pose_examples
