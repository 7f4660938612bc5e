// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stance_target.h"
#include "Rigid_limb.h"
#include "Straight_limb.h"
#include "limb_goals.h"
#include "smooth_step.h"
#include "../target/aligning_motion.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// The trunk, straight: what is near the arms turns about its axis, so that these are level, and what is near the legs.
Stance_target trunk(const Body_plan& body)
{
  constexpr double least = .1;
  const Eigen::Matrix3d &chest = body.frames()[0], &hips = body.frames()[1];
  const Eigen::Vector3d axis = hips * body.axis().transpose();
  const Eigen::AngleAxisd twist(Eigen::Quaterniond(chest * hips.transpose()));
  const double angle = twist.angle() * (twist.axis().dot(axis) < 0 ? -1 : 1);
  Stance_target result = {(body.pose().rowwise() - body.origin()) * hips.transpose(),
                          Eigen::VectorXd::Ones(body.pose().rows()),
                          {}};
  for(Eigen::Index v = 0; v < result.points.rows(); ++v)
  {
    const double share = body.share_of_chest(v);
    result.points.row(v)
      = (Eigen::AngleAxisd(share * angle, axis) * Eigen::Vector3d(result.points.row(v).transpose()))
          .transpose();
    if(body.kind() == Skeleton_3::Kind::PERSON && share > least && share < 1 - least)
      result.weights[v] = 0;
  }
  return result;
}

// Moves the points of a limb, and blends them with the trunk near its root. There, and in wrist or ankle, nothing is matched.
template <class Moved_limb>
void blend(const Body_plan& body, const Limb& limb, const Point_matrix& points,
           const Point_matrix& trunk, const Moved_limb& moved, Stance_target& result)
{
  constexpr double least_share = .03;
  for(Eigen::Index v = 0; v < points.rows(); ++v)
  {
    const double share = body.share_of_limb(limb, v);
    if(share == 0)
      continue;
    result.points.row(v)
      = share * moved(points.row(v).transpose(), v).transpose() + (1 - share) * trunk.row(v);
    const bool is_in_joint = share > least_share && share < 1 - least_share;
    if(is_in_joint || moved.is_in_end(v))
      result.weights[v] = 0;
  }
}

// The angle by which a hand is turned about its arm so that it lies level, with the palm downward and the thumb in front; 0 if it is
// not wide, or if the arm points to the front. `moved`: the straight arm.
double angle_of_hand(const Body_plan& body, const Limb& arm, const bool is_left,
                     const Point_matrix& points, const Straight_limb& moved)
{
  constexpr double least_ratio = 1.15, least_across = .5;
  const Eigen::Vector3d front = Eigen::Vector3d::UnitZ(), &direction = moved.direction(),
                        across = front - front.dot(direction) * direction;
  if(across.norm() < least_across)
    return 0;
  Eigen::Matrix<double, 3, 2> axes; // their sides: the thumb's and, of the left hand, the palm's
  axes << across.normalized(), direction.cross(across).normalized();
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(points.rows());
  Eigen::MatrixX2d hand = Eigen::MatrixX2d::Zero(points.rows(), 2);
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    if(arm.distances[v] < arm.end)
    {
      shares[v] = body.shares()[v];
      hand.row(v) = (axes.transpose() * moved(points.row(v).transpose(), v)).transpose();
    }
  if(!(shares.sum() > 0))
    return 0;
  shares /= shares.sum();
  const Eigen::RowVector2d mean = shares.transpose() * hand;
  hand.rowwise() -= mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(hand.transpose() * shares.asDiagonal()
                                                              * hand);
  const Eigen::Vector2d deviations = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  if(!(deviations[1] > least_ratio * deviations[0]))
    return 0;
  // By distance from the tip, the half at the wrist has the thumb, on its side and on that of the palm. The other half is opposite.
  const Eigen::RowVector2d fingers
    = (arm.distances.array() < arm.end / 2).select(shares, 0).transpose() * hand;
  Eigen::Vector2d wide = solver.eigenvectors().col(1);
  const Eigen::Vector2d deep(-wide[1], wide[0]);
  if(fingers.dot(wide) / deviations[1] + (is_left ? 1 : -1) * fingers.dot(deep) / deviations[0] > 0)
    wide = -wide;
  return -std::atan2(wide[1], wide[0]);
}

// The direction in the plane of up and front whose angle from the front is the nearest one within limits, in degrees.
Eigen::Vector3d level_direction(const Eigen::Vector3d& direction, const double least,
                                const double largest)
{
  const double front = direction[2] < 0 ? -1 : 1,
               angle = std::clamp(std::atan2(direction[1], front * direction[2]),
                                  least * CGAL_PI / 180, largest * CGAL_PI / 180);
  return {0, std::sin(angle), front * std::cos(angle)};
}

// Moves neck and tail of an animal where they are at rest, and levels the head.
void rest_neck_and_tail(const Body_plan& body, const Point_matrix& straight, Stance_target& result)
{
  const Eigen::Vector3d nose(0, -.25, 1);
  const auto move = [&](const Limb& limb, const double least, const double largest,
                        const std::optional<Eigen::Vector3d>& direction_of_tip) {
    const Eigen::Vector3d direction = level_direction(
      (body.center(straight, limb, limb.end) - body.center(straight, limb, limb.root)).transpose(),
      least, largest);
    const Straight_limb moved(body, limb, straight, direction, 1, direction_of_tip);
    blend(body, limb, straight, straight, moved, result);
  };
  Limb head = body.head();
  head.tip = body.nose();
  move(head, 15, 45, nose);
  if(body.tail())
    move(*body.tail(), -60, -30, std::nullopt);
}

// Gives the head the shape that it has in the input: the canonical pose bends what sticks out of it, such as ears.
void restore_head(const Body_plan& body, Stance_target& result)
{
  constexpr double width = .1; // in which it is blended with the neck
  const Limb& head = body.head();
  const Point_matrix rest = body.rest();
  Eigen::VectorXd shares(rest.rows());
  for(Eigen::Index v = 0; v < rest.rows(); ++v)
    shares[v] = smooth_step((head.end - head.distances[v]) / width);
  const Eigen::VectorXd weights = shares.cwiseProduct(body.shares());
  if(!(weights.sum() > 0))
    return;
  const Point_matrix moved
    = (aligning_motion(rest, result.points, weights) * rest.transpose()).transpose();
  for(Eigen::Index v = 0; v < rest.rows(); ++v)
  {
    result.points.row(v) += shares[v] * (moved.row(v) - result.points.row(v));
    if(shares[v] > 0 && shares[v] < 1)
      result.weights[v] = 0;
  }
}

} // namespace

Eigen::Vector3d direction_of_limb(const Body_plan& body, const Limb& limb,
                                  const Point_matrix& points)
{
  return (body.end_joint(points, limb) - body.center(points, limb, limb.root)).transpose();
}

Stance_target stance_target(const Body_plan& body, const Method_options::Stance stance,
                            const Limb_goals& goals)
{
  constexpr double least_stretch = .85, largest_stretch = 1.1;
  Stance_target result = trunk(body);
  const Point_matrix straight = result.points;
  // The canonical pose is stretched; both limbs of a pair are as long as in the input, where it is not bent too much to tell.
  std::array<double, 2> stretches;
  for(std::size_t pair = 0; pair < 2; ++pair)
    stretches[pair] = std::clamp((body.relative_length_of_rest(body.limbs()[2 * pair])
                                  + body.relative_length_of_rest(body.limbs()[2 * pair + 1]))
                                   / 2,
                                 least_stretch, largest_stretch);
  for(std::size_t i = 0; i < body.limbs().size(); ++i)
  {
    const Limb& limb = body.limbs()[i];
    const Limb_goal& goal = goals[i];
    const Eigen::Matrix3d& frame = body.frames()[i < 2 ? 0 : 1];
    const Point_matrix points = (body.pose().rowwise() - body.origin()) * frame.transpose();
    if(goal.direction && goal.is_straightened)
    {
      Straight_limb moved(body, limb, points, *goal.direction, stretches[i / 2],
                          goal.direction_of_tip);
      if(!goal.direction_of_tip)
        moved.twist(angle_of_hand(body, limb, i % 2 == 0, points, moved), 1);
      blend(body, limb, points, straight, moved, result);
      result.directions[i] = *goal.direction;
    }
    else
    {
      blend(body, limb, points, straight, Rigid_limb(body, limb, points, goal.direction), result);
      result.directions[i] = direction_of_limb(body, limb, result.points).normalized();
    }
  }
  if(stance == Method_options::Stance::STAND)
    rest_neck_and_tail(body, straight, result);
  restore_head(body, result);
  result.points *= body.unit();
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
