// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stances of figures whose limbs are known.

#include "../../examples/Canonical_pose_3/Articulated_animal.h"
#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/algorithm/string/join.hpp>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "engine/stance/mirror_plane_normal.h"
#include "engine/stance/relief_in_front.h"
#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_stances {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_examples::Articulated_figure;
using Canonical_pose_examples::Joint_angles;
using Canonical_pose_examples::Landmark;
using Canonical_pose_test::to_matrix;
using CP::Limb_direction_3;
using CP::Options;
using CP::Point_matrix;
using CP::Result;
using CP::Skeleton_3;
using Limb = Limb_direction_3::Limb;
using Stance = Options::Stance;
using Kernel = CGAL::Simple_cartesian<double>;

constexpr std::size_t NUMBER_OF_VERTICES = 4000;

Options in_stance(const Stance stance)
{
  Options options;
  options.stance = stance;
  return options;
}

template <class Triangles>
Result result_of(const Point_matrix& points, const Triangles& triangles, const Options& options)
{
  std::vector<Kernel::Point_3> input, pose;
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    input.emplace_back(points(i, 0), points(i, 1), points(i, 2));
  return CGAL::canonical_pose_3(input, triangles, pose, options);
}

const Skeleton_3::Joint& joint(const Skeleton_3& skeleton, const std::string& name)
{
  const auto found
    = std::find_if(skeleton.joints.begin(), skeleton.joints.end(),
                   [&](const Skeleton_3::Joint& candidate) { return candidate.name == name; });
  if(found == skeleton.joints.end())
    throw std::out_of_range("there is no joint " + name);
  return *found;
}

// In degrees, between the bone from one joint to another and a direction.
double angle_of(const Skeleton_3& skeleton, const std::string& from, const std::string& to,
                const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d bone
    = (joint(skeleton, to).position - joint(skeleton, from).position).transpose();
  return std::acos(bone.normalized().dot(direction.normalized())) * 180 / CGAL_PI;
}

Eigen::RowVector3d at(const Result& result, const std::size_t vertex)
{
  return result.pose.row(static_cast<Eigen::Index>(vertex));
}

// Of what is near a vertex, from one pose to another one.
Eigen::Matrix3d rotation_at(const std::size_t vertex, const double radius, const Point_matrix& from,
                            const Point_matrix& to)
{
  const auto v = static_cast<Eigen::Index>(vertex);
  std::vector<Eigen::Index> near;
  for(Eigen::Index i = 0; i < from.rows(); ++i)
    if((from.row(i) - from.row(v)).norm() < radius)
      near.push_back(i);
  return Eigen::umeyama(Eigen::Matrix3Xd(from(near, Eigen::all).transpose()),
                        Eigen::Matrix3Xd(to(near, Eigen::all).transpose()), false)
    .topLeftCorner<3, 3>();
}

std::size_t vertex_at(const Result& result, const Eigen::RowVector3d& position)
{
  Eigen::Index vertex = 0;
  (result.pose.rowwise() - position).rowwise().squaredNorm().minCoeff(&vertex);
  return static_cast<std::size_t>(vertex);
}

// By how much each vertex follows a joint.
Eigen::VectorXd weights_of(const Skeleton_3& skeleton, const std::string& name)
{
  return skeleton.weights.col(&joint(skeleton, name) - skeleton.joints.data());
}

// By how much edges that follow a joint are longer in a pose than in the input.
template <class Triangles>
double stretch_of(const std::string& name, const Triangles& triangles, const Point_matrix& points,
                  const Result& result)
{
  const Eigen::VectorXd weights = weights_of(*result.skeleton, name);
  double before = 0, after = 0;
  for(const auto& triangle : triangles)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto a = static_cast<Eigen::Index>(triangle[k]),
                 b = static_cast<Eigen::Index>(triangle[(k + 1) % 3]);
      if((std::min)(weights[a], weights[b]) < .5)
        continue;
      before += (points.row(a) - points.row(b)).norm();
      after += (result.pose.row(a) - result.pose.row(b)).norm();
    }
  return after / before;
}

// The height of the lowest point that follows a joint.
double lowest_point(const Result& result, const std::string& name)
{
  const Eigen::VectorXd weights = weights_of(*result.skeleton, name);
  double lowest = (std::numeric_limits<double>::infinity)();
  for(Eigen::Index v = 0; v < weights.size(); ++v)
    if(weights[v] > .5)
      lowest = (std::min)(lowest, result.pose(v, 1));
  return lowest;
}

// The skeleton of a body of this kind, whose pose is as good as a pose should be.
const Skeleton_3& checked_skeleton(const Result& result, const Skeleton_3::Kind kind)
{
  EXPECT_EQ(result.summary.inverted, 0u);
  EXPECT_LT(result.summary.median_edge_strain, .08);
  const Skeleton_3& skeleton = result.skeleton.value();
  EXPECT_EQ(skeleton.kind, kind);
  EXPECT_TRUE(skeleton.is_front_certain);
  return skeleton;
}

// Exact: directions of limbs, left, up and front. The figure stands with its front toward +z, so its left hand has x > 0; the
// postures hide nothing of that. Its rest shape has level palms.
TEST(Stances, person_from_any_posture)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const std::size_t left_hand = figure.landmark(Landmark::LEFT_HAND),
                    right_hand = figure.landmark(Landmark::RIGHT_HAND),
                    left_foot = figure.landmark(Landmark::LEFT_FOOT),
                    head = figure.landmark(Landmark::HEAD);
  const Point_matrix rest = to_matrix(figure.points({}));
  const double length_of_hand = .1 * (rest.col(0).maxCoeff() - rest.col(0).minCoeff());
  std::vector<Point_matrix> poses;
  for(const auto& posture : Articulated_figure::named_poses())
  {
    SCOPED_TRACE(posture.name);
    const Point_matrix points = to_matrix(figure.points(posture.angles));
    const Result result = result_of(points, figure.triangles(), in_stance(Stance::T));
    ASSERT_TRUE(result.is_usable());
    EXPECT_EQ(result.summary.warnings, std::vector<std::string>());
    const Skeleton_3& skeleton = checked_skeleton(result, Skeleton_3::Kind::PERSON);
    constexpr double largest_angle = 7;
    EXPECT_LT(angle_of(skeleton, "left elbow", "left wrist", {1, 0, 0}), largest_angle);
    EXPECT_LT(angle_of(skeleton, "right elbow", "right wrist", {-1, 0, 0}), largest_angle);
    EXPECT_LT(angle_of(skeleton, "left knee", "left ankle", {0, -1, 0}), largest_angle);
    EXPECT_LT(angle_of(skeleton, "right knee", "right ankle", {0, -1, 0}), largest_angle);
    // Nothing is farther to the left than the fingers of the left hand, nothing higher than the head; toes point to the front.
    const double size = result.pose.col(1).maxCoeff();
    EXPECT_NEAR(result.pose.col(1).minCoeff(), 0, 1e-9 * size);
    EXPECT_GT(at(result, left_hand)[0], result.pose.col(0).maxCoeff() - .1 * size);
    EXPECT_LT(at(result, right_hand)[0], result.pose.col(0).minCoeff() + .1 * size);
    EXPECT_GT(at(result, head)[1], .95 * size);
    EXPECT_GT(at(result, left_foot)[2], joint(skeleton, "left ankle").position[2] + .05 * size);
    for(const std::size_t hand : {left_hand, right_hand})
      EXPECT_GT(rotation_at(hand, length_of_hand, rest, result.pose)(1, 1), .9) << hand;
    // Knees and the head point to the front, as in the rest shape; and limbs have the lengths of the input.
    EXPECT_GT(rotation_at(head, length_of_hand, rest, result.pose)(2, 2), .95);
    for(const char* const name : {"left knee", "right knee"})
      EXPECT_GT(rotation_at(vertex_at(result, joint(skeleton, name).position), length_of_hand, rest,
                            result.pose)(2, 2),
                .9)
        << name;
    for(const char* const name : {"left elbow", "right elbow", "left knee", "right knee"})
      EXPECT_NEAR(stretch_of(name, figure.triangles(), points, result), 1, .05) << name;
    poses.push_back(result.pose);
  }
  for(std::size_t i = 1; i < poses.size(); ++i)
    EXPECT_LT(CP::pose_difference(poses[0], poses[i]), .06) << i;
}

// Exact: the head of the rest shape looks to the front and is level, so it does wherever the input has it.
TEST(Stances, turned_and_bent_head)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const std::size_t head = figure.landmark(Landmark::HEAD);
  const auto pose_of = [&](const double turn, const double bend) {
    Joint_angles angles;
    angles.neck.turn = turn;
    angles.neck.bend = bend;
    return result_of(to_matrix(figure.points(angles)), figure.triangles(), in_stance(Stance::T))
      .pose;
  };
  const Point_matrix straight = pose_of(0, 0);
  const double radius = .08 * straight.col(1).maxCoeff();
  for(const auto& [turn, bend] : {std::make_pair(70., 0.), {-50., 0.}, {0., 30.}, {0., -20.}})
  {
    const Point_matrix pose = pose_of(turn, bend);
    const Eigen::Matrix3d rotation = rotation_at(head, radius, straight, pose);
    EXPECT_LT(std::acos(std::min(rotation(0, 0), 1.)) * 180 / CGAL_PI, 12) << turn << ' ' << bend;
    EXPECT_LT(std::acos(std::min(rotation(1, 1), 1.)) * 180 / CGAL_PI, 12) << turn << ' ' << bend;
  }
}

// Exact: legs are as long as those of the rest shape, although the skin of knees is compressed where they are folded.
TEST(Stances, length_of_folded_legs)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const auto length_of_leg = [&](const double knee) {
    Joint_angles angles;
    angles.left_leg.knee = angles.right_leg.knee = knee;
    const Result result
      = result_of(to_matrix(figure.points(angles)), figure.triangles(), in_stance(Stance::T));
    return (joint(*result.skeleton, "left hip").position
            - joint(*result.skeleton, "left ankle").position)
      .norm();
  };
  EXPECT_NEAR(length_of_leg(165) / length_of_leg(0), 1, .07);
}

TEST(Stances, directions_of_all_stances)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points(Articulated_figure::named_poses()[0].angles));
  struct Expected
  {
    Stance stance;
    Eigen::Vector3d arm, leg;
  };
  for(const Expected& expected :
      {Expected{Stance::A, {1, -1, 0}, {0, -1, 0}}, {Stance::VITRUVIAN, {1, 0, 0}, {.4, -1, 0}}})
  {
    const Result result = result_of(points, figure.triangles(), in_stance(expected.stance));
    EXPECT_LT(angle_of(*result.skeleton, "left elbow", "left wrist", expected.arm), 6);
    EXPECT_LT(angle_of(*result.skeleton, "left knee", "left ankle", expected.leg), 6);
  }
}

Options with_directions(const std::vector<Limb_direction_3>& directions,
                        const Stance stance = Stance::CANONICAL)
{
  Options options = in_stance(stance);
  options.limb_directions = directions;
  return options;
}

// Exact: what T says, with names or with vertices.
TEST(Stances, directions_of_a_named_stance)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points(Articulated_figure::named_poses()[1].angles));
  const Result expected = result_of(points, figure.triangles(), in_stance(Stance::T));
  std::vector<Limb_direction_3> directions = {{Limb::LEFT_ARM, {1, 0, 0}},
                                              {Limb::RIGHT_ARM, {-1, 0, 0}},
                                              {Limb::LEFT_LEG, {.03, -1, 0}},
                                              {Limb::RIGHT_LEG, {-.03, -1, 0}}};
  EXPECT_EQ(result_of(points, figure.triangles(), with_directions(directions)).pose, expected.pose);
  const std::vector<Landmark> tips
    = {Landmark::LEFT_HAND, Landmark::RIGHT_HAND, Landmark::LEFT_FOOT, Landmark::RIGHT_FOOT};
  for(std::size_t i = 0; i < tips.size(); ++i)
    directions[i].limb = figure.landmark(tips[i]);
  EXPECT_EQ(result_of(points, figure.triangles(), with_directions(directions)).pose, expected.pose);
  // The other limbs are those of the stance.
  directions.resize(1);
  directions[0].direction *= 1e-310;
  EXPECT_EQ(result_of(points, figure.triangles(), with_directions(directions, Stance::T)).pose,
            expected.pose);
}

// Exact: the directions that are asked for, and those of the stance.
TEST(Stances, given_directions)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points(Articulated_figure::named_poses()[0].angles));
  const Result result = result_of(
    points, figure.triangles(),
    with_directions({{Limb::LEFT_ARM, {1, 2, 0}}, {Limb::RIGHT_LEG, {-.3, -1, 1}}}, Stance::A));
  const Skeleton_3& skeleton = checked_skeleton(result, Skeleton_3::Kind::PERSON);
  constexpr double largest_angle = 7;
  EXPECT_LT(angle_of(skeleton, "left elbow", "left wrist", {1, 2, 0}), largest_angle);
  EXPECT_LT(angle_of(skeleton, "right elbow", "right wrist", {-1, -1, 0}), largest_angle);
  EXPECT_LT(angle_of(skeleton, "left knee", "left ankle", {0, -1, 0}), largest_angle);
  EXPECT_LT(angle_of(skeleton, "right knee", "right ankle", {-.3, -1, 1}), largest_angle);
  // Toes of a leg that is raised to the front point to the front and upward.
  const Eigen::RowVector3d toes
    = at(result, figure.landmark(Landmark::RIGHT_FOOT)) - joint(skeleton, "right ankle").position;
  EXPECT_GT(toes[1], 0);
  EXPECT_GT(toes[2], 0);
}

// The elbow of an arm that stays as it is bends as in the canonical pose. A straight one does not.
TEST(Stances, limbs_as_they_are)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points(Articulated_figure::named_poses()[2].angles));
  const auto bend = [](const Result& result) {
    const Skeleton_3& skeleton = *result.skeleton;
    const Eigen::RowVector3d lower
      = joint(skeleton, "left wrist").position - joint(skeleton, "left elbow").position;
    return angle_of(skeleton, "left shoulder", "left elbow", lower.transpose());
  };
  Options options;
  options.frame = Options::Frame::BODY;
  const double bend_of_pose = bend(result_of(points, figure.triangles(), options));
  const Eigen::RowVector3d up(1, 1, .2);
  std::array<double, 2> bends;
  for(const bool is_straightened : {false, true})
  {
    const Result result = result_of(points, figure.triangles(),
                                    with_directions({{Limb::LEFT_ARM, up, is_straightened}}));
    EXPECT_EQ(result.summary.warnings, std::vector<std::string>());
    EXPECT_LT(angle_of(*result.skeleton, "left shoulder", "left wrist", up.transpose()), 10);
    bends[is_straightened ? 1 : 0] = bend(result);
  }
  EXPECT_NEAR(bends[0], bend_of_pose, 5);
  EXPECT_LT(bends[1], .5 * bends[0]);
}

// An arm that points to the other side passes through the chest, or the head; arms and legs of T pass through nothing.
TEST(Stances, limbs_through_each_other)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points());
  const auto warnings = [&](const Options& options) {
    return result_of(points, figure.triangles(), options).summary.warnings;
  };
  EXPECT_EQ(warnings(in_stance(Stance::T)), std::vector<std::string>());
  // Across the chest, and down into it, so that no skin is crossed but at the joint.
  for(const Eigen::RowVector3d& direction :
      {Eigen::RowVector3d(-1, 0, 0), Eigen::RowVector3d(-.3, -1, 0)})
    EXPECT_EQ(warnings(with_directions({{Limb::LEFT_ARM, direction}})),
              std::vector<std::string>{
                "parts pass through each other in the stance: left arm and trunk or head"});
}

// An arm whose part beyond the elbow is shrunk is shorter than its partner, and a warning says so.
TEST(Stances, limbs_of_different_lengths)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  Point_matrix points = to_matrix(figure.points());
  Options options;
  options.frame = Options::Frame::BODY;
  const Skeleton_3 skeleton = *result_of(points, figure.triangles(), options).skeleton;
  const Eigen::VectorXd lower = weights_of(skeleton, "left elbow"),
                        hand = weights_of(skeleton, "left wrist"),
                        elbow = weights_of(skeleton, "left shoulder").cwiseProduct(lower);
  const Eigen::RowVector3d center = elbow.transpose() * points / elbow.sum();
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    points.row(v) -= .6 * (lower[v] + hand[v]) * (points.row(v) - center);
  const Result result = result_of(points, figure.triangles(), in_stance(Stance::T));
  EXPECT_EQ(
    result.summary.warnings,
    std::vector<std::string>{"limbs have different lengths in the stance: left arm and right arm"});
  // Nevertheless, the trunk stands upright.
  for(const std::string name : {"shoulder", "hip"})
  {
    const Eigen::RowVector3d way = joint(*result.skeleton, "left " + name).position
                                   - joint(*result.skeleton, "right " + name).position;
    EXPECT_LT(std::abs(way[1]), .1 * way.norm()) << name;
  }
  EXPECT_LT(angle_of(*result.skeleton, "hips", "neck", {0, 1, 0}), 5);
}

// An arm that is not matched remains bent, and a warning says so.
TEST(Stances, limb_that_remains_bent)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  Joint_angles angles;
  angles.left_arm.elbow = 90;
  const Point_matrix points = to_matrix(figure.points(angles));
  Options options = in_stance(Stance::T);
  const Skeleton_3 skeleton = *result_of(points, figure.triangles(), options).skeleton;
  options.matching_weights = Eigen::VectorXd::Ones(points.rows());
  for(const char* const name : {"left shoulder", "left elbow", "left wrist"})
    options.matching_weights -= weights_of(skeleton, name);
  options.matching_weights = options.matching_weights.cwiseMax(0);
  const auto warnings = result_of(points, figure.triangles(), options).summary.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const std::string& warning) {
                            return warning.find("limbs are bent in the stance: left arm by ") == 0;
                          }))
    << boost::algorithm::join(warnings, "\n");
}

// Each defect of a direction is told with its index.
TEST(Stances, directions_that_are_refused)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points());
  Eigen::Index belly;
  (points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().minCoeff(&belly);
  const Limb_direction_3 good = {Limb::LEFT_ARM, {1, 1, 0}};
  const std::size_t hand = figure.landmark(Landmark::LEFT_HAND),
                    head = figure.landmark(Landmark::HEAD);
  for(const auto& [bad, text] : std::vector<std::pair<Limb_direction_3, std::string>>{
        {{hand, {1, 0, 0}}, "names a vertex of the left arm, which occurs before"},
        {{head, {1, 0, 0}}, "names a vertex that is on none of the limbs left arm, right arm, "},
        {{static_cast<std::size_t>(belly), {1, 0, 0}}, "names a vertex that is on none of"},
        {{Limb::LEFT_FRONT_LEG, {1, 0, 0}},
         "names the left front leg, but the shape is like a person, whose limbs are left arm, "}})
    EXPECT_THROW_WITH(result_of(points, figure.triangles(), with_directions({good, bad})),
                      CP::Limb_direction_error, "limb direction 1 " + text);
}

// Exact: the axes; which of the legs are those in front follows from the rest shape of the animal, which looks toward +z. The
// head is level, with its own shape, and the tail hangs.
TEST(Stances, animal_from_any_posture)
{
  const Articulated_animal animal(NUMBER_OF_VERTICES);
  const Point_matrix rest = to_matrix(animal.points());
  Eigen::Index front, back, ear, left;
  rest.col(2).maxCoeff(&front);
  rest.col(2).minCoeff(&back);
  rest.col(1).maxCoeff(&ear);
  rest.col(0).maxCoeff(&left);
  for(const auto& posture : Articulated_animal::named_poses())
  {
    SCOPED_TRACE(posture.name);
    const Point_matrix points = to_matrix(animal.points(posture.angles));
    const Result result = result_of(points, animal.triangles(), in_stance(Stance::STAND));
    ASSERT_TRUE(result.is_usable());
    const Skeleton_3& skeleton = checked_skeleton(result, Skeleton_3::Kind::FOUR_LEGGED);
    for(const std::string side : {"left ", "right "})
      for(const auto& [from, to] :
          std::map<std::string, std::string>{{"elbow", "wrist"}, {"knee", "ankle"}})
        EXPECT_LT(angle_of(skeleton, side + from, side + to, {0, -1, 0}), 12) << side << to;
    const double size = result.pose.col(1).maxCoeff();
    EXPECT_GT(result.pose(front, 2), joint(skeleton, "chest").position[2] + .1 * size);
    EXPECT_GT(result.pose(left, 0), joint(skeleton, "hips").position[0]);
    EXPECT_GT(joint(skeleton, "left wrist").position[0],
              joint(skeleton, "right wrist").position[0]);
    EXPECT_LT(angle_of(skeleton, "chest", "neck", {0, 1, 1}), 35);
    const Eigen::RowVector3d head = result.pose.row(front) - joint(skeleton, "neck").position,
                             tail = result.pose.row(back) - joint(skeleton, "tail").position;
    EXPECT_LT(std::abs(std::atan2(head[1], head[2])), 30 * CGAL_PI / 180);
    EXPECT_LT(tail[1], 0);
    EXPECT_LT(tail[2], 0);
    // Ears are as far from the nose as in the input.
    EXPECT_NEAR((result.pose.row(ear) - result.pose.row(front)).norm()
                  / (points.row(ear) - points.row(front)).norm(),
                1, .25);
  }
}

// Exact: legs of a pair are beside each other, also if they are forward and backward in the input.
TEST(Stances, legs_of_an_animal_that_walks)
{
  const Articulated_animal animal(NUMBER_OF_VERTICES);
  Canonical_pose_examples::Animal_joint_angles angles;
  angles.left_foreleg.flexion = angles.right_hind_leg.flexion = 45;
  angles.right_foreleg.flexion = angles.left_hind_leg.flexion = -35;
  const Result result
    = result_of(to_matrix(animal.points(angles)), animal.triangles(), in_stance(Stance::STAND));
  const double size = result.pose.col(1).maxCoeff();
  for(const std::string name : {"shoulder", "elbow", "wrist", "hip", "knee", "ankle"})
  {
    const Eigen::RowVector3d way = joint(*result.skeleton, "left " + name).position
                                   - joint(*result.skeleton, "right " + name).position;
    EXPECT_LT(std::hypot(way[1], way[2]), .02 * size) << name;
    EXPECT_NEAR(way[0], .2, .03) << name; // as at rest: thighs do not stick out
  }
}

// Hind legs that are somewhat shorter become longer, since folded legs seem shorter. Those of half the length do not reach the floor, and
// a warning says so.
TEST(Stances, feet_on_the_floor_and_above)
{
  const Articulated_animal animal(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(animal.points());
  const Skeleton_3 skeleton
    = *result_of(points, animal.triangles(), in_stance(Stance::STAND)).skeleton;
  const auto with_short_hind_legs = [&](const double factor) {
    Point_matrix changed = points;
    for(const std::string side : {"left ", "right "})
    {
      const Eigen::VectorXd hip
        = weights_of(skeleton, side + "hip"),
        leg = hip + weights_of(skeleton, side + "knee") + weights_of(skeleton, side + "ankle"),
        top = hip.cwiseProduct(Eigen::VectorXd::Ones(points.rows()) - leg);
      const double height = top.dot(points.col(1)) / top.sum();
      changed.col(1) -= (1 - factor) * leg.cwiseProduct((points.col(1).array() - height).matrix());
    }
    return result_of(changed, animal.triangles(), in_stance(Stance::STAND));
  };
  const Result somewhat = with_short_hind_legs(.8);
  EXPECT_EQ(somewhat.summary.warnings, std::vector<std::string>());
  for(const char* const name : {"left wrist", "right wrist", "left ankle", "right ankle"})
    EXPECT_LT(lowest_point(somewhat, name), .03 * somewhat.pose.col(1).maxCoeff()) << name;
  EXPECT_EQ(with_short_hind_legs(.5).summary.warnings,
            std::vector<std::string>{
              "feet are above the floor in the stance: left hind leg, right hind leg"});
}

// A paw that is given.
TEST(Stances, given_direction_of_an_animal)
{
  const Articulated_animal animal(NUMBER_OF_VERTICES);
  const Result result
    = result_of(to_matrix(animal.points()), animal.triangles(),
                with_directions({{Limb::LEFT_FRONT_LEG, {.2, 0, 1}}}, Stance::STAND));
  const Skeleton_3& skeleton = *result.skeleton;
  EXPECT_LT(angle_of(skeleton, "left elbow", "left wrist", {.2, 0, 1}), 15);
  EXPECT_LT(angle_of(skeleton, "right elbow", "right wrist", {0, -1, 0}), 12);
  for(const char* const name : {"right wrist", "left ankle", "right ankle"})
    EXPECT_LT(lowest_point(result, name), .03 * result.pose.col(1).maxCoeff()) << name;
}

// Exact: in the frame of the body, the stance of a moved and scaled copy is the scaled one.
TEST(Stances, motion_and_scale)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(figure.points(Articulated_figure::named_poses()[1].angles));
  constexpr double scale = 100;
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  Point_matrix moved = scale * points * rotation.transpose();
  moved.rowwise() += Eigen::RowVector3d(7, -8, 9);
  const Result result = result_of(points, figure.triangles(), in_stance(Stance::T)),
               result_of_moved = result_of(moved, figure.triangles(), in_stance(Stance::T));
  EXPECT_LT((result_of_moved.pose / scale - result.pose).cwiseAbs().maxCoeff(),
            1e-4 * result.pose.col(1).maxCoeff());
  // Near the input, it is the same up to a motion.
  Options options = in_stance(Stance::T);
  options.frame = Options::Frame::INPUT;
  const Result near_input = result_of(points, figure.triangles(), options);
  EXPECT_LT(CP::pose_difference(near_input.pose, result.pose), 1e-9);
  EXPECT_TRUE(near_input.motion.isApprox(Eigen::Isometry3d::Identity()));
  const Point_matrix upright
    = (near_input.skeleton->frame * near_input.pose.transpose()).transpose();
  EXPECT_LT((upright - result.pose).cwiseAbs().maxCoeff(), 1e-9);
}

// Exact: weights are a partition of unity, and the tips of limbs follow the last joints alone.
TEST(Stances, weights_of_the_skeleton)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  Options options;
  options.frame = Options::Frame::BODY;
  const Result result = result_of(to_matrix(figure.points()), figure.triangles(), options);
  const Skeleton_3& skeleton = *result.skeleton;
  ASSERT_EQ(skeleton.weights.rows(), result.pose.rows());
  ASSERT_EQ(skeleton.weights.cols(), static_cast<Eigen::Index>(skeleton.joints.size()));
  for(Eigen::Index v = 0; v < skeleton.weights.rows(); ++v)
  {
    double sum = 0;
    int number = 0;
    for(Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(skeleton.weights, v);
        entry; ++entry, ++number)
    {
      EXPECT_GE(entry.value(), 0);
      sum += entry.value();
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_LE(number, 4);
  }
  for(std::size_t j = 0; j < skeleton.joints.size(); ++j)
    EXPECT_LE(skeleton.joints[j].parent, j);
  const std::map<Landmark, std::string> last = {{Landmark::LEFT_HAND, "left wrist"},
                                                {Landmark::RIGHT_HAND, "right wrist"},
                                                {Landmark::LEFT_FOOT, "left ankle"},
                                                {Landmark::RIGHT_FOOT, "right ankle"},
                                                {Landmark::HEAD, "neck"}};
  for(const auto& [landmark, name] : last)
    EXPECT_NEAR(skeleton.weights.coeff(static_cast<Eigen::Index>(figure.landmark(landmark)),
                                       &joint(skeleton, name) - skeleton.joints.data()),
                1, 1e-12)
      << name;
  EXPECT_NEAR(result.pose.col(1).minCoeff(), 0, 1e-9);
  EXPECT_TRUE(skeleton.frame.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
}

// The canonical pose itself is not changed by a frame.
TEST(Stances, canonical_pose_in_the_frame_of_the_body)
{
  const Articulated_animal animal(NUMBER_OF_VERTICES);
  const Point_matrix points = to_matrix(animal.points());
  Options options;
  const Result near_input = result_of(points, animal.triangles(), options);
  EXPECT_FALSE(near_input.skeleton);
  options.frame = Options::Frame::BODY;
  const Result upright = result_of(points, animal.triangles(), options);
  const Point_matrix moved = (upright.motion * near_input.pose.transpose()).transpose();
  EXPECT_LT((moved - upright.pose).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Stances, other_shapes_are_refused)
{
  const Articulated_figure figure(NUMBER_OF_VERTICES);
  const Articulated_animal animal(NUMBER_OF_VERTICES);
  EXPECT_THROW_WITH(
    result_of(to_matrix(figure.points()), figure.triangles(), in_stance(Stance::STAND)),
    std::invalid_argument, "the shape is like a person");
  EXPECT_THROW_WITH(result_of(to_matrix(animal.points()), animal.triangles(), in_stance(Stance::A)),
                    std::invalid_argument, "the shape is like an animal with four legs");
  const auto tube = Canonical_pose_test::tube_soup(20, 12, 5, .5);
  EXPECT_THROW_WITH(result_of(to_matrix(tube.points), tube.triangles, in_stance(Stance::T)),
                    std::invalid_argument,
                    "no head and four limbs were found, but 2 parts that stick out, ");
  const auto ball = Canonical_pose_test::icosphere_soup(2, 1);
  EXPECT_THROW_WITH(result_of(to_matrix(ball.points), ball.triangles, in_stance(Stance::T)),
                    std::invalid_argument, "no head and four limbs were found");
}

// Exact: the reflected head has the opposite value. A sphere, whose mesh is the same in front and at the back, has none; one with a
// nose has more relief where the nose is.
TEST(Stances, relief_of_the_face)
{
  const auto sphere = Canonical_pose_test::icosphere_soup(4, 1.);
  Point_matrix points = to_matrix(sphere.points);
  const Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  EXPECT_NEAR(CP::internal::relief_in_front(points, sphere.triangles, frame), 0, 1e-9);
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    if(points(v, 2) > .8)
      points(v, 2) += points(v, 2) - .8;
  const double relief = CP::internal::relief_in_front(points, sphere.triangles, frame);
  EXPECT_GT(relief, .5);
  Eigen::Matrix3d reversed;
  reversed << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  EXPECT_NEAR(CP::internal::relief_in_front(points, sphere.triangles, reversed), -relief, 1e-9);
}

// Exact: the turned head is symmetric about its own plane, whose normal is turned with it. A sphere is symmetric about all planes.
TEST(Stances, mirror_plane_of_a_head)
{
  const auto sphere = Canonical_pose_test::icosphere_soup(4, 1.);
  Point_matrix points = to_matrix(sphere.points);
  const Eigen::Vector3d left = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY();
  EXPECT_EQ(CP::internal::mirror_plane_normal(points, left, up), left);
  for(Eigen::Index v = 0; v < points.rows(); ++v)
  {
    const Eigen::RowVector3d p = points.row(v);
    points(v, 0) += (p[0] < 0 ? -1 : 1) * (std::max)(std::abs(p[0]) - .9, 0.); // ears
    points(v, 1) *= 1.3;
    points(v, 2) += .5 * p[1] * (std::max)(p[2], 0.)
                    + 2 * (std::max)(p[2] - .9, 0.); // forehead, chin, and nose
  }
  for(const double angle : {-45., -10., 0., 30.})
  {
    const Eigen::Matrix3d rotation
      = (Eigen::AngleAxisd(angle * CGAL_PI / 180, Eigen::Vector3d::UnitY())
         * Eigen::AngleAxisd(.3, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
    const Point_matrix turned = points * rotation.transpose();
    const Eigen::Vector3d across = CP::internal::mirror_plane_normal(turned, left, up);
    EXPECT_LT(std::acos(across.dot(rotation * left)) * 180 / CGAL_PI, 3) << angle;
  }
}

// The prism over a star with five points, all alike: none is a head.
TEST(Stances, limbs_that_are_all_alike)
{
  constexpr std::size_t n = 10;
  Point_matrix points(2 * n, 3);
  std::vector<std::vector<std::size_t>> faces(2);
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n),
                 radius = i % 2 == 0 ? 5 : 1;
    for(std::size_t side = 0; side < 2; ++side)
      points.row(static_cast<Eigen::Index>(side * n + i)) << radius * std::cos(angle),
        radius * std::sin(angle), side == 0 ? -.3 : .3;
    const std::size_t next = (i + 1) % n;
    faces[0].insert(faces[0].begin(), i);
    faces[1].push_back(n + i);
    faces.push_back({i, next, n + next, n + i});
  }
  EXPECT_THROW_WITH(result_of(points, faces, in_stance(Stance::T)), std::invalid_argument,
                    "no head and four limbs were found, but limbs that are all alike");
}

// The surface of boxes, given by two corners each, of unit cubes.
Canonical_pose_test::Triangle_soup
surface_of_boxes(const std::array<std::size_t, 3>& size,
                 const std::vector<std::array<std::array<double, 3>, 2>>& boxes)
{
  auto body = Canonical_pose_test::tetrahedral_box(
    size[0], size[1], size[2],
    {{static_cast<double>(size[0]), static_cast<double>(size[1]), static_cast<double>(size[2])}});
  const auto is_outside = [&](const std::array<std::size_t, 4>& cell) {
    return std::none_of(boxes.begin(), boxes.end(), [&](const auto& box) {
      return std::all_of(cell.begin(), cell.end(), [&](const std::size_t v) {
        for(std::size_t k = 0; k < 3; ++k)
          if(body.points[v][k] < box[0][k] || body.points[v][k] > box[1][k])
            return false;
        return true;
      });
    });
  };
  body.cells.erase(std::remove_if(body.cells.begin(), body.cells.end(), is_outside),
                   body.cells.end());
  return Canonical_pose_test::boundary(body);
}

// Each of them has four limbs and a fifth part. Fingers are joined by a palm, not by a trunk; the back of a chair is a plate; and
// what is as thick as long is no limb.
TEST(Stances, hands_chairs_and_stubs_are_refused)
{
  const auto expect_refusal
    = [](const std::array<std::size_t, 3>& size,
         const std::vector<std::array<std::array<double, 3>, 2>>& boxes, const char* const reason) {
        const auto surface = surface_of_boxes(size, boxes);
        EXPECT_THROW_WITH(
          result_of(to_matrix(surface.points), surface.triangles, in_stance(Stance::STAND)),
          std::invalid_argument, std::string("no head and four limbs were found, but ") + reason);
      };
  expect_refusal({40, 4, 40},
                 {{{{{16, 0, 16}}, {{24, 2, 24}}}},
                  {{{{16, 0, 24}}, {{18, 2, 40}}}},
                  {{{{22, 0, 24}}, {{24, 2, 40}}}},
                  {{{{0, 0, 16}}, {{16, 2, 18}}}},
                  {{{{24, 0, 16}}, {{40, 2, 18}}}},
                  {{{{17, 0, 0}}, {{23, 4, 16}}}}},
                 "limbs without a trunk between them");
  expect_refusal({8, 8, 26},
                 {{{{{0, 0, 14}}, {{8, 8, 15}}}},
                  {{{{0, 0, 0}}, {{1, 1, 14}}}},
                  {{{{7, 0, 0}}, {{8, 1, 14}}}},
                  {{{{0, 7, 0}}, {{1, 8, 14}}}},
                  {{{{7, 7, 0}}, {{8, 8, 14}}}},
                  {{{{2, 0, 15}}, {{6, 1, 26}}}}},
                 "four limbs and a part that is flat");
  expect_refusal({20, 8, 28},
                 {{{{{6, 0, 6}}, {{14, 8, 28}}}},
                  {{{{0, 2, 15}}, {{6, 6, 19}}}},
                  {{{{14, 2, 15}}, {{20, 6, 19}}}},
                  {{{{6, 2, 0}}, {{9, 6, 6}}}},
                  {{{{11, 2, 0}}, {{14, 6, 6}}}}},
                 "limbs that are thicker than long");
}

// The same for two models of a face graph, whatever the number of threads.
TEST(Stances, face_graphs_and_threads)
{
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Articulated_figure figure(2000);
  Mesh mesh = figure.make_mesh<Mesh>();
  Polyhedron polyhedron = figure.make_mesh<Polyhedron>();
  Options options = in_stance(Stance::A);
  options.number_of_threads = 1;
  const Result result = CGAL::canonical_pose_3(mesh, get(CGAL::vertex_point, mesh), options);
  options.number_of_threads = 2;
  const Result of_polyhedron
    = CGAL::canonical_pose_3(polyhedron, get(CGAL::vertex_point, polyhedron), options);
  EXPECT_EQ(result.pose, of_polyhedron.pose);
}

} // namespace test_stances
