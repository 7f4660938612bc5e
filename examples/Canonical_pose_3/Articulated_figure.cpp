// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Anatomy.h"
#include "Articulated_figure.h"
#include "merge_contact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Canonical_pose_examples {

namespace detail {

double head(const Vector& p)
{
  double f = ellipsoid(p, {0, 1.685, -0.008}, {0.084, 0.106, 0.104});
  f = smooth_minimum(f, ellipsoid(p, {0, 1.612, 0.034}, {0.058, 0.056, 0.062}), 0.05);
  f = smooth_minimum(f, capsule(p, {0, 1.70, 0.094}, {0, 1.653, 0.117}, 0.008, 0.017), 0.015);
  f = smooth_minimum(f, capsule(p, {0.02, 1.718, 0.086}, {0.05, 1.714, 0.068}, 0.01, 0.008), 0.03);
  f = smooth_minimum(f, capsule(p, {0, 1.608, 0.094}, {0.022, 1.61, 0.087}, 0.009, 0.005), 0.01);
  f = smooth_minimum(f, ellipsoid(p, {0.086, 1.668, -0.008}, {0.014, 0.036, 0.024}), 0.012);
  return f;
}

double trunk(const Vector& p)
{
  double f = ellipsoid(p, {0, 0.97, -0.01}, {0.165, 0.13, 0.118});
  f = smooth_minimum(f, ellipsoid(p, {0, 1.12, 0}, {0.135, 0.16, 0.1}), 0.08);
  f = smooth_minimum(f, ellipsoid(p, {0, 1.29, -0.005}, {0.168, 0.18, 0.115}), 0.08);
  f = smooth_minimum(f, ellipsoid(p, {0.078, 1.345, 0.066}, {0.075, 0.06, 0.042}), 0.05);
  f = smooth_minimum(f, capsule(p, {0.02, 1.47, -0.02}, {0.17, 1.42, -0.005}, 0.05, 0.045), 0.05);
  f = smooth_minimum(f, capsule(p, {0, 1.42, -0.015}, {0, 1.6, 0.0}, 0.06, 0.052), 0.04);
  // Folds on the belly, and a belt.
  f -= 0.005 * std::sin((p.y() - 1.08) * 114) * smoothstep(1.07, 1.09, p.y())
       * (1 - smoothstep(1.23, 1.26, p.y())) * smoothstep(-0.02, 0.05, p.z());
  return f - 0.009 * ridge(p.y() - 1.03);
}

double arm(const Vector& p)
{
  double f = capsule(p, {0.17, 1.41, 0}, {0.45, 1.41, 0}, 0.062, 0.04);
  f = smooth_minimum(f, ellipsoid(p, {0.31, 1.415, 0.01}, {0.1, 0.046, 0.048}), 0.03);
  f = smooth_minimum(f, capsule(p, {0.45, 1.41, 0}, {0.70, 1.41, 0}, 0.04, 0.028), 0.03);
  f = smooth_minimum(f, ellipsoid(p, {0.53, 1.41, 0}, {0.09, 0.044, 0.045}), 0.03);
  f -= 0.008 * ridge(p.x() - 0.675); // cuff
  f = smooth_minimum(f, ellipsoid(p, {0.765, 1.41, 0}, {0.07, 0.024, 0.05}), 0.03);
  f = smooth_minimum(f, capsule(p, {0.745, 1.408, 0.03}, {0.8, 1.405, 0.088}, 0.019, 0.015), 0.01);
  f = smooth_minimum(f, capsule(p, {0.81, 1.41, 0.03}, {0.885, 1.408, 0.054}, 0.017, 0.014), 0.01);
  f = smooth_minimum(f, capsule(p, {0.81, 1.41, 0}, {0.905, 1.408, 0}, 0.018, 0.015), 0.01);
  const double outer = capsule(p, {0.81, 1.41, -0.03}, {0.885, 1.408, -0.054}, 0.017, 0.014);
  return smooth_minimum(f, outer, 0.01);
}

double leg(const Vector& p)
{
  double f = capsule(p, {0.093, 0.93, 0}, {0.122, 0.5, 0.005}, 0.088, 0.056);
  f = smooth_minimum(f, ellipsoid(p, {0.085, 0.93, -0.055}, {0.085, 0.1, 0.085}), 0.04);
  f = smooth_minimum(f, capsule(p, {0.122, 0.5, 0.005}, {0.15, 0.09, -0.012}, 0.055, 0.038), 0.03);
  f = smooth_minimum(f, ellipsoid(p, {0.130, 0.36, -0.02}, {0.052, 0.12, 0.055}), 0.04);
  f = smooth_minimum(f, ellipsoid(p, {0.122, 0.51, 0.045}, {0.035, 0.045, 0.025}), 0.03); // knee
  f -= 0.008 * ridge(p.y() - 0.19);                                                       // boot
  f = smooth_minimum(f, capsule(p, {0.15, 0.05, -0.03}, {0.16, 0.035, 0.14}, 0.047, 0.040), 0.03);
  f = smooth_minimum(f, ellipsoid(p, {0.161, 0.035, 0.135}, {0.048, 0.03, 0.055}), 0.02);
  return -smooth_minimum(-f, p.y(), 0.015); // sole
}

Rod arm_rod(const Joint_angles::Arm& a)
{
  const Eigen::AngleAxisd shoulder(about(Vector::UnitY(), -a.forward)
                                   * about(Vector::UnitZ(), a.raise));
  return Rod(Vector(0, 1.41, 0), Vector::UnitX(), 0.95,
             {{0.19, 0.115, shoulder},
              {0.32, 0.12, about(Vector::UnitX(), -a.twist)},
              {0.45, 0.11, about(Vector::UnitY(), -a.elbow)},
              {0.71, 0.04, about(Vector::UnitZ(), -a.wrist)}});
}

Rod leg_rod(const Joint_angles::Leg& a)
{
  const Eigen::AngleAxisd hip(about(Vector::UnitZ(), a.abduction)
                              * about(Vector::UnitX(), -a.flexion));
  return Rod(Vector(0.085, 1.08, 0.02), Vector(0.065, -0.99, 0).normalized(), 1.1,
             {{0.165, 0.165, hip},
              {0.58, 0.15, about(Vector::UnitX(), a.knee)},
              {0.98, 0.06, about(Vector::UnitX(), a.ankle)}});
}

Rod spine_rod(const Joint_angles::Trunk& spine, const Joint_angles::Trunk& neck)
{
  auto rotation = [](const Joint_angles::Trunk& a) {
    return Eigen::AngleAxisd(about(Vector::UnitX(), a.bend) * about(Vector::UnitZ(), -a.lean)
                             * about(Vector::UnitY(), a.turn));
  };
  return Rod(Vector(0, 1, 0), Vector::UnitY(), 0.85,
             {{0.17, 0.15, rotation(spine)}, {0.55, 0.07, rotation(neck)}});
}

/// Bends the person along rods through limbs and spine.
class Person
{
public:
  using Joint_angles = Canonical_pose_examples::Joint_angles;

  explicit Person(const Joint_angles& a)
    : arms(arm_rod(a.right_arm), arm_rod(a.left_arm)),
      legs(leg_rod(a.right_leg), leg_rod(a.left_leg)), spine(spine_rod(a.spine, a.neck))
  {}

  Vector operator()(const Vector& p) const { return spine(p.y() - 1, with_limbs(p)); }

  /// Negative inside the rest pose.
  static double rest_shape(Vector p)
  {
    p.x() = std::sqrt(p.x() * p.x() + 2.5e-5); // rounds the crease at the plane of symmetry
    double f = smooth_minimum(trunk(p), head(p), 0.03);
    f = smooth_minimum(f, arm(p), 0.05);
    return smooth_minimum(f, leg(p), 0.04);
  }

  /// Suitable relative edge length around `p`: smaller where there is detail.
  static double suitable_length(const Vector& p)
  {
    const double face = smoothstep(1.5, 1.6, p.y()) * smoothstep(-0.06, 0.05, p.z());
    const double hand = smoothstep(0.68, 0.76, std::abs(p.x()));
    const double belly
      = (1 - smoothstep(0.12, 0.18, std::abs(p.y() - 1.13))) * smoothstep(0, 0.05, p.z());
    return 1 - 0.45 * (std::max)({face, hand, 0.6 * belly});
  }

private:
  Pair_of_rods arms, legs;
  Rod spine;

  Vector with_limbs(const Vector& p) const
  {
    // Far from its axis, the arm starts farther out, so that the chest does not move.
    const double off_axis = std::hypot(p.y() - 1.41, p.z());
    const double arm = std::abs(p.x()) - 1.2 * (std::max)(0., off_axis - 0.05);
    return arm > 0.075 ? arms(arm, p) : legs(1.08 - p.y(), p);
  }
};

} // namespace detail

template class Articulated_shape<detail::Person, Joint_angles>;

std::size_t Articulated_figure::landmark(const Landmark which) const
{
  const Eigen::Vector3d tips[5] = {{0.92, 1.408, 0},
                                   {-0.92, 1.408, 0},
                                   {0.161, 0.035, 0.19},
                                   {-0.161, 0.035, 0.19},
                                   {0, 1.793, 0}};
  return nearest_vertex(tips[static_cast<int>(which)]);
}

Articulated_figure::Triangles Articulated_figure::merged_triangles() const
{
  return merge_contact(points(hand_on_knee()), triangles(), nearest_vertex({0.79, 1.388, 0}),
                       nearest_vertex({0.122, 0.545, 0.062}), 0.02);
}

Articulated_figure::Joint_angles Articulated_figure::hand_on_knee()
{
  Joint_angles angles;
  angles.left_arm = {-35, 53, -21, 44, -26};
  angles.right_arm = {-62, 5, 0, 12, 0};
  angles.left_leg = {93, -5, 110, 0};
  angles.right_leg = {10, 4, 15, 0};
  angles.spine = {16, 0, -15};
  angles.neck = {-8, 0, 0};
  return angles;
}

std::vector<Articulated_figure::Named_pose> Articulated_figure::named_poses()
{
  std::vector<Named_pose> poses(5);
  poses[0].name = "standing";
  poses[0].angles.left_arm = poses[0].angles.right_arm = {-62, 5, 0, 12, 0};

  poses[1].name = "sitting";
  poses[1].angles.left_arm = poses[1].angles.right_arm = {-50, 15, 0, 50, 0};
  poses[1].angles.left_leg = poses[1].angles.right_leg = {72, 6, 75, 0};

  poses[2].name = "running";
  poses[2].angles.left_arm = {-55, -30, 0, 70, 0};
  poses[2].angles.right_arm = {-45, 45, 0, 70, 0};
  poses[2].angles.left_leg = {50, 0, 55, 0};
  poses[2].angles.right_leg = {-18, 0, 55, 25};
  poses[2].angles.spine = {12, 0, 10};
  poses[2].angles.neck = {-8, 0, -8};

  poses[3].name = "waving";
  poses[3].angles.left_arm = {-35, 0, 0, 20, 0};
  poses[3].angles.right_arm = {15, 10, 80, 75, -10};
  poses[3].angles.left_leg = {0, 8, 0, 0};
  poses[3].angles.right_leg = {0, 8, 0, 0};
  poses[3].angles.spine = {0, 8, 0};
  poses[3].angles.neck = {0, -12, 0};

  poses[4].name = "crouching";
  poses[4].angles.left_arm = {-12, 65, 0, 15, 0};
  poses[4].angles.right_arm = {-12, 65, 0, 15, 0};
  poses[4].angles.left_leg = {85, 12, 100, -12};
  poses[4].angles.right_leg = {85, 12, 100, -12};
  poses[4].angles.spine = {22, 0, 0};
  poses[4].angles.neck = {-15, 0, 0};
  return poses;
}

} // namespace Canonical_pose_examples
