// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stance_target.h"
#include "Moved_limb.h"
#include "limb_goals.h"
#include "mirror_plane_normal.h"
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
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// The pose, moved along the axis of the trunk so that this is as long as in the input. Limbs follow their joints, and those of a pair are
// moved beside each other.
Point_matrix with_trunk_of_rest(const Body_plan& body)
{
  constexpr std::size_t number = 8; // of sections
  constexpr double reach = .1;      // of a joint into the trunk
  const double length = body.length_of_trunk() / number;
  const Eigen::VectorXd heights = (body.pose().rowwise() - body.origin()) * body.axis().transpose();
  Eigen::VectorXd heights_of_trunk = heights; // elsewhere infinite
  for(const Limb& limb : body.limbs())
    for(Eigen::Index v = 0; v < heights.size(); ++v)
      if(body.share_of_limb(limb, v) > 0)
        heights_of_trunk[v] = (std::numeric_limits<double>::infinity)();
  const std::vector<double> stretches = body.stretches_of_rest(
    body.pose(), std::vector<Eigen::Vector3d>(number, body.axis().transpose()), heights_of_trunk,
    [&](const double height) {
      const double section = height / length;
      return section >= 0 && section < static_cast<double>(number)
               ? static_cast<std::size_t>(section)
               : number;
    });
  const auto shift = [&](const double height) {
    double result = 0;
    for(std::size_t k = 0; k < number; ++k)
      result
        += std::clamp(height - length * static_cast<double>(k), 0., length) * (stretches[k] - 1);
    return result;
  };
  std::array<Eigen::RowVector3d, 4> ways_of_joints;
  for(std::size_t i = 0; i < ways_of_joints.size(); ++i)
  {
    const auto joint = [&](const std::size_t limb) {
      const Limb& of = body.limbs()[limb];
      return Eigen::RowVector3d(body.center(body.pose(), of, of.root) - body.origin());
    };
    const Eigen::RowVector3d left = body.frames()[i / 2].row(0);
    const Eigen::RowVector3d own = joint(i), other = joint(i ^ 1), to_middle = (other - own) / 2;
    ways_of_joints[i] = to_middle - to_middle.dot(left) * left
                        + shift((own + to_middle).dot(body.axis())) * body.axis();
  }
  Point_matrix result = body.pose();
  for(Eigen::Index v = 0; v < result.rows(); ++v)
  {
    Eigen::RowVector3d way = shift(heights[v]) * body.axis();
    for(std::size_t i = 0; i < ways_of_joints.size(); ++i)
    {
      const Limb& limb = body.limbs()[i];
      way += smooth_step((limb.root - limb.distances[v]) / reach + 1) * (ways_of_joints[i] - way);
    }
    result.row(v) += way;
  }
  return result;
}

// The trunk, straight: what is near the arms turns about its axis, so that these are level, and what is near the legs.
Stance_target trunk(const Body_plan& body, const Point_matrix& pose)
{
  constexpr double least = .1;
  const Eigen::Matrix3d &chest = body.frames()[0], &hips = body.frames()[1];
  const Eigen::Vector3d axis = hips * body.axis().transpose();
  const Eigen::AngleAxisd twist(Eigen::Quaterniond(chest * hips.transpose()));
  const double angle = twist.angle() * (twist.axis().dot(axis) < 0 ? -1 : 1);
  Stance_target result
    = {(pose.rowwise() - body.origin()) * hips.transpose(), Eigen::VectorXd::Ones(pose.rows()), {}};
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

// Moves the points of a limb, and blends them with what is there near its root. There, and in wrist or ankle, nothing is matched.
void blend(const Body_plan& body, const Limb& limb, const Point_matrix& points,
           const Moved_limb& moved, Stance_target& result)
{
  constexpr double least_share = .03;
  for(Eigen::Index v = 0; v < points.rows(); ++v)
  {
    const double share = body.share_of_limb(limb, v);
    if(share == 0)
      continue;
    result.points.row(v)
      += share * (moved(points.row(v).transpose(), v).transpose() - result.points.row(v));
    const bool is_in_joint = share > least_share && share < 1 - least_share;
    if(is_in_joint || moved.is_in_end(v))
      result.weights[v] = 0;
  }
}

// Both are as long as the longer one: where a limb is folded, its skin is shorter.
void make_equally_long(Moved_limb& limb, Moved_limb& other)
{
  const double length = (std::max)(limb.length(), other.length());
  limb.lengthen(length / limb.length());
  other.lengthen(length / other.length());
}

// Makes the pair of legs whose feet are higher longer, within limits: where legs are folded, they are shorter. Of legs that do not stand,
// the other one of the pair decides.
void put_on_one_floor(const Body_plan& body, const Limb_goals& goals,
                      const std::array<Point_matrix, 2>& points, std::vector<Moved_limb>& legs)
{
  constexpr double largest_factor = 1.4;
  std::array<double, 2> floors = {0, 0}, lengths = {0, 0};
  for(std::size_t pair = 0; pair < 2; ++pair)
  {
    double number = 0;
    for(const std::size_t i : {2 * pair, 2 * pair + 1})
    {
      if(!goals[i].stands())
        continue;
      const Limb& leg = body.limbs()[i];
      double lowest = (std::numeric_limits<double>::infinity)();
      for(Eigen::Index v = 0; v < leg.distances.size(); ++v)
        if(leg.distances[v] <= leg.end)
          lowest = (std::min)(lowest, legs[i](points[pair].row(v).transpose(), v).y());
      floors[pair] += lowest;
      lengths[pair] += legs[i].length();
      ++number;
    }
    if(number == 0)
      return;
    floors[pair] /= number;
    lengths[pair] /= number;
  }
  const std::size_t higher = floors[0] > floors[1] ? 0 : 1;
  const double factor
    = (std::min)(1 + (floors[higher] - floors[1 - higher]) / lengths[higher], largest_factor);
  for(const std::size_t i : {2 * higher, 2 * higher + 1})
    legs[i].lengthen(factor);
}

// The angle by which a hand is turned about its arm so that it lies level, with the palm downward and the thumb in front; 0 if it is
// not wide, or if the arm points to the front. `moved`: the straight arm.
double angle_of_hand(const Body_plan& body, const Limb& arm, const bool is_left,
                     const Point_matrix& points, const Moved_limb& moved)
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
    const Moved_limb moved(body, limb, straight, {direction, true, direction_of_tip});
    blend(body, limb, straight, moved, result);
  };
  Limb head = body.head();
  head.tip = body.nose();
  move(head, 15, 45, nose);
  if(body.tail())
    move(*body.tail(), -60, -30, std::nullopt);
}

// By which the head of a person is turned about the axis to the left, so that it is level: its middle is a little in front of that of the
// ring around the neck, as it is for persons who stand and look ahead. 0 if it is elsewhere by far.
double angle_to_level(const Eigen::Vector3d& middle_from_neck)
{
  constexpr double angle_of_level_head = 8, least = -15, largest = 60;
  const double angle
    = angle_of_level_head
      - std::atan2(middle_from_neck.z(), middle_from_neck.y()) * 180 / CGAL_PI;
  return angle >= least && angle <= largest ? angle * CGAL_PI / 180 : 0;
}

// Gives the head the shape that it has in the input, since the canonical pose bends what sticks out of it, such as ears, and turns it
// so that its left side is on the left.
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
  std::vector<Eigen::Index> vertices;
  for(Eigen::Index v = 0; v < rest.rows(); ++v)
    if(shares[v] == 1)
      vertices.push_back(v);
  Eigen::Isometry3d motion = aligning_motion(rest, result.points, weights);
  const Eigen::Vector3d left = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY(),
                        pivot = body.center(result.points, head, head.end).transpose();
  const Eigen::Matrix3d rotation = motion.linear();
  const Eigen::Vector3d across = mirror_plane_normal(
    rest(vertices, Eigen::all), rotation.transpose() * left, rotation.transpose() * up);
  const auto turn = [&](const Eigen::Quaterniond& about_pivot) {
    motion = Eigen::Translation3d(pivot) * about_pivot * Eigen::Translation3d(-pivot) * motion;
  };
  turn(Eigen::Quaterniond::FromTwoVectors(rotation * across, left));
  if(body.kind() == Skeleton_3::Kind::PERSON)
  {
    const Eigen::Vector3d middle
      = (weights.transpose() * rest).transpose() / weights.sum(),
      from_neck = motion.linear() * (middle - body.center(rest, head, head.end).transpose());
    turn(Eigen::Quaterniond(Eigen::AngleAxisd(angle_to_level(from_neck), left)));
  }
  const Point_matrix moved = (motion * rest.transpose()).transpose();
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
  const Point_matrix pose = with_trunk_of_rest(body);
  Stance_target result = trunk(body, pose);
  const Point_matrix straight = result.points;
  std::array<Point_matrix, 2> points;
  std::vector<Moved_limb> limbs;
  for(std::size_t i = 0; i < goals.size(); ++i)
  {
    if(i % 2 == 0)
      points[i / 2] = (pose.rowwise() - body.origin()) * body.frames()[i / 2].transpose();
    limbs.emplace_back(body, body.limbs()[i], points[i / 2], goals[i]);
  }
  for(const std::size_t i : {0, 2})
    if(body.is_like(body.limbs()[i], body.limbs()[i + 1]))
      make_equally_long(limbs[i], limbs[i + 1]);
  if(stance == Method_options::Stance::STAND)
    put_on_one_floor(body, goals, points, limbs);
  for(std::size_t i = 0; i < goals.size(); ++i)
  {
    const Limb& limb = body.limbs()[i];
    if(goals[i].is_straight() && !goals[i].direction_of_tip)
      limbs[i].twist(angle_of_hand(body, limb, i % 2 == 0, points[i / 2], limbs[i]), 1);
    blend(body, limb, points[i / 2], limbs[i], result);
    result.directions[i] = goals[i].is_straight()
                             ? *goals[i].direction
                             : direction_of_limb(body, limb, result.points).normalized();
  }
  if(stance == Method_options::Stance::STAND)
    rest_neck_and_tail(body, straight, result);
  else if(body.kind() == Skeleton_3::Kind::PERSON)
    blend(body, body.head(), straight,
          Moved_limb(body, body.head(), straight, {Eigen::Vector3d::UnitY(), true, {}}), result);
  restore_head(body, result);
  result.points *= body.unit();
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
