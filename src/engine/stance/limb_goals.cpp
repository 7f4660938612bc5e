// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "limb_goals.h"
#include "Body_plan.h"

#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

using Stance = Method_options::Stance;
using Kind = Skeleton_3::Kind;

constexpr std::size_t limbs_of_a_kind = 4;

// Of the limbs on the left.
struct Named_directions
{
  Eigen::Vector3d arms, legs;
};

Named_directions directions_of(const Stance stance, const Kind kind)
{
  const bool is_person = kind == Kind::PERSON;
  if(is_person == (stance == Stance::STAND))
    throw std::invalid_argument(
      is_person ? "standing is a stance of animals with four legs, but the shape is like a person"
                : "T, A and Vitruvian are stances of persons, but the shape is like an animal with "
                  "four legs");
  const Eigen::Vector3d level(1, 0, 0), down(0, -1, 0);
  switch(stance)
  {
  case Stance::A:
    return {{1, -1, 0}, {.03, -1, 0}};
  case Stance::VITRUVIAN:
    return {level, {.4, -1, 0}};
  case Stance::STAND:
    return {down, down};
  default:
    return {level, {.03, -1, 0}};
  }
}

// Of a foot at a straight leg: to the front, but turned with the leg about the axis to the left.
Eigen::Vector3d direction_of_foot(const Kind kind, const Eigen::Vector3d& leg)
{
  const Eigen::Vector3d foot
    = kind == Kind::PERSON ? Eigen::Vector3d(0, -.35, 1) : Eigen::Vector3d(0, -1, .45);
  if(leg[2] == 0 && leg[1] <= 0)
    return foot;
  return Eigen::AngleAxisd(std::atan2(-leg[2], -leg[1]), Eigen::Vector3d::UnitX()) * foot;
}

Limb_goal goal_of(const Kind kind, const std::size_t limb, const Eigen::Vector3d& direction,
                  const bool is_straightened)
{
  Limb_goal goal;
  // Of any length that a number has.
  goal.direction = (direction / direction.cwiseAbs().maxCoeff()).normalized();
  goal.is_straightened = is_straightened;
  if(is_straightened && (limb >= 2 || kind == Kind::FOUR_LEGGED)) // hands are straight
    goal.direction_of_tip = direction_of_foot(kind, *goal.direction);
  return goal;
}

std::string names_of_limbs(const Kind kind)
{
  std::string result;
  for(std::size_t limb = 0; limb < limbs_of_a_kind; ++limb)
    result += (limb == 0 ? "" : ", ") + name_of_limb(kind, limb);
  return result;
}

Kind kind_of(const Limb_direction_3::Limb limb)
{
  return limb < Limb_direction_3::Limb::LEFT_FRONT_LEG ? Kind::PERSON : Kind::FOUR_LEGGED;
}

std::size_t index_of(const Limb_direction_3::Limb limb)
{
  return static_cast<std::size_t>(limb) % limbs_of_a_kind;
}

std::size_t limb_of(const Body_plan& body, const Limb_direction_3& direction,
                    const std::size_t index)
{
  if(const auto* const limb = std::get_if<Limb_direction_3::Limb>(&direction.limb))
  {
    if(kind_of(*limb) != body.kind())
      throw Limb_direction_error(
        index, "names the " + name_of_limb(kind_of(*limb), index_of(*limb))
                 + ", but the shape is like "
                 + (body.kind() == Kind::PERSON ? "a person" : "an animal with four legs")
                 + ", whose limbs are " + names_of_limbs(body.kind()));
    return index_of(*limb);
  }
  const auto vertex = static_cast<Eigen::Index>(std::get<std::size_t>(direction.limb));
  double largest = 0;
  std::size_t result = limbs_of_a_kind;
  for(std::size_t limb = 0; limb < limbs_of_a_kind; ++limb)
    if(const double share = body.share_of_limb(body.limbs()[limb], vertex); share > largest)
    {
      largest = share;
      result = limb;
    }
  if(result == limbs_of_a_kind)
    throw Limb_direction_error(index, "names a vertex that is on none of the limbs "
                                        + names_of_limbs(body.kind()));
  return result;
}

} // namespace

std::string name_of_limb(const Skeleton_3::Kind kind, const std::size_t limb)
{
  const bool is_person = kind == Kind::PERSON;
  const std::array<const char*, limbs_of_a_kind> names
    = {is_person ? "left arm" : "left front leg", is_person ? "right arm" : "right front leg",
       is_person ? "left leg" : "left hind leg", is_person ? "right leg" : "right hind leg"};
  return names[limb];
}

void check_limb_directions(const std::vector<Limb_direction_3>& directions,
                           const std::size_t number_of_vertices)
{
  using Limb = Limb_direction_3::Limb;
  std::set<Limb> named;
  for(std::size_t i = 0; i < directions.size(); ++i)
  {
    const Limb_direction_3& direction = directions[i];
    const auto refuse_if = [&](const bool condition, const std::string& defect) {
      if(condition)
        throw Limb_direction_error(i, defect);
    };
    if(const auto* const limb = std::get_if<Limb>(&direction.limb))
    {
      const int number = static_cast<int>(*limb);
      refuse_if(number < 0 || number > static_cast<int>(Limb::RIGHT_HIND_LEG),
                "names limb " + std::to_string(number) + ", which is not one of the enumerators");
      refuse_if(!named.insert(*limb).second, "names the "
                                               + name_of_limb(kind_of(*limb), index_of(*limb))
                                               + ", which occurs before");
    }
    else
    {
      const auto* const vertex = std::get_if<std::size_t>(&direction.limb);
      refuse_if(vertex == nullptr, "names no limb");
      refuse_if(*vertex >= number_of_vertices, "names vertex " + std::to_string(*vertex)
                                                 + ", but there are "
                                                 + std::to_string(number_of_vertices));
    }
    refuse_if(!direction.direction.allFinite(), "has a direction that is not finite");
    refuse_if((direction.direction.array() == 0).all(), "has a direction of length 0");
  }
}

Limb_goals limb_goals(const Body_plan& body, const Stance stance,
                      const std::vector<Limb_direction_3>& directions)
{
  Limb_goals goals;
  if(stance != Stance::CANONICAL)
  {
    const Named_directions named = directions_of(stance, body.kind());
    for(std::size_t i = 0; i < goals.size(); ++i)
    {
      Eigen::Vector3d direction = i < 2 ? named.arms : named.legs;
      if(i % 2 == 1)
        direction[0] *= -1;
      goals[i] = goal_of(body.kind(), i, direction, true);
    }
  }
  std::set<std::size_t> limbs;
  for(std::size_t i = 0; i < directions.size(); ++i)
  {
    const Limb_direction_3& direction = directions[i];
    const std::size_t limb = limb_of(body, direction, i);
    if(!limbs.insert(limb).second)
      throw Limb_direction_error(i, std::string(std::holds_alternative<std::size_t>(direction.limb)
                                                  ? "names a vertex of the "
                                                  : "names the ")
                                      + name_of_limb(body.kind(), limb) + ", which occurs before");
    goals[limb]
      = goal_of(body.kind(), limb, direction.direction.transpose(), direction.is_straightened);
  }
  return goals;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
