// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_MOVED_LIMB_H
#define CANONICAL_POSE_3_ENGINE_STANCE_MOVED_LIMB_H

#include "Body_plan.h"
#include "limb_goals.h"
#include "smooth_step.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A limb that is turned about its root, and is as long as in the input: sections move with their centers. If it is straightened, they
// are rotated such that the center line becomes straight, from one section to the next about the axis in which it is bent there.
// Then it can be twisted.
class Moved_limb
{
public:
  // `points`: the vertices of the body, of which the limb is a part.
  Moved_limb(const Body_plan& body, const Limb& limb, const Point_matrix& points,
             const Limb_goal& goal)
    : m_distances(limb.distances), m_end(limb.end), m_width_of_end((std::min)(.05, .1 * limb.root))
  {
    constexpr double length_of_section = .05, width = .035;
    const auto number = static_cast<std::size_t>(
      (std::max)(2., std::round((limb.root - m_end) / length_of_section)));
    m_length = (limb.root - m_end) / static_cast<double>(number);
    for(std::size_t k = 0; k <= number; ++k)
      m_centers.emplace_back(
        body.center(points, limb, m_end + m_length * static_cast<double>(k), width));
    m_centers.front() = body.end_joint(points, limb);
    for(int pass = 0; pass < 2; ++pass)
    {
      const std::vector<Eigen::Vector3d> before = m_centers;
      for(std::size_t k = 1; k < number; ++k)
        m_centers[k] = (before[k - 1] + 2 * before[k] + before[k + 1]) / 4;
    }
    std::vector<Eigen::Vector3d> tangents;
    for(std::size_t k = 0; k < number; ++k)
      tangents.push_back(tangent(k).normalized());
    m_along_tip
      = (points.row(static_cast<Eigen::Index>(limb.tip)).transpose() - m_centers[0]).normalized();
    tangents.push_back(m_along_tip);
    const std::vector<double> stretches
      = body.stretches_of_rest(points, tangents, m_distances, [&](const double distance) {
          const double section = (distance - m_end) / m_length;
          return section < 0                             ? number
                 : section < static_cast<double>(number) ? static_cast<std::size_t>(section)
                                                         : number + 1;
        });
    m_stretch_of_tip = stretches[number];
    // Knees that are folded far are lumps, through which the line of centers takes a short cut.
    const bool is_leg = body.kind() == Skeleton_3::Kind::PERSON && goal.direction_of_tip;
    std::vector<Eigen::Vector3d> sections;
    Eigen::Vector3d to_end = Eigen::Vector3d::Zero();
    for(std::size_t k = 0; k < number; ++k)
    {
      sections.push_back(stretches[k]
                         * (is_leg ? Eigen::Vector3d(m_length * tangents[k]) : tangent(k)));
      to_end += sections[k];
    }
    m_direction = goal.direction.value_or(to_end.normalized());
    m_rotations.assign(number, Eigen::Quaterniond::FromTwoVectors(to_end, m_direction));
    m_positions.resize(number + 1);
    m_positions[number] = m_centers[number];
    for(std::size_t k = number; k-- > 0;)
    {
      if(goal.is_straight())
        m_rotations[k]
          = k + 1 == number
              ? Eigen::Quaterniond::FromTwoVectors(tangent(k), m_direction)
              : m_rotations[k + 1] * Eigen::Quaterniond::FromTwoVectors(tangent(k), tangent(k + 1));
      m_positions[k] = m_positions[k + 1]
                       + (goal.is_straight() ? sections[k].norm() * m_direction
                                             : Eigen::Vector3d(m_rotations[k] * sections[k]));
    }
    if(!goal.is_straight())
      return;
    const auto to_tip = [&]() -> Eigen::Vector3d {
      return moved(points.row(static_cast<Eigen::Index>(limb.tip)).transpose(), 0) - m_positions[0];
    };
    std::optional<Eigen::Vector3d> front;
    if(body.kind() == Skeleton_3::Kind::PERSON)
      front = align_with_rest(body, limb, points);
    if(goal.direction_of_tip)
    {
      twist(angle_about(m_direction, front.value_or(to_tip()), *goal.direction_of_tip), .5);
      m_rotation_of_tip = Eigen::Quaterniond::FromTwoVectors(to_tip(), *goal.direction_of_tip);
    }
  }

  const Eigen::Vector3d& direction() const { return m_direction; }

  // From the root to the end.
  double length() const
  {
    double result = 0;
    for(std::size_t k = 1; k < m_positions.size(); ++k)
      result += (m_positions[k] - m_positions[k - 1]).norm();
    return result;
  }

  // Makes the limb longer, from the root to the end.
  void lengthen(const double factor)
  {
    for(Eigen::Vector3d& position : m_positions)
      position = m_positions.back() + factor * (position - m_positions.back());
  }

  // Turns the limb about its line, by a share of the angle that grows from the root to a share of the length.
  void twist(const double angle, const double share_of_length)
  {
    m_twist = angle;
    m_length_of_twist = share_of_length * (m_length * static_cast<double>(m_rotations.size()));
  }

  // Where a vertex of the limb is moved.
  Eigen::Vector3d operator()(const Eigen::Vector3d& point, const Eigen::Index vertex) const
  {
    const double distance = m_distances[vertex];
    const Eigen::Vector3d result = moved(point, distance);
    if(!m_rotation_of_tip || distance > m_end + m_width_of_end)
      return result;
    const double share = (m_end + m_width_of_end - distance) / (2 * m_width_of_end);
    return m_positions[0]
           + Eigen::Quaterniond::Identity().slerp((std::min)(share, 1.), *m_rotation_of_tip)
               * (result - m_positions[0]);
  }

  // Whether a vertex is in wrist or ankle, where the tip is rotated.
  bool is_in_end(const Eigen::Index vertex) const
  {
    return m_rotation_of_tip && std::abs(m_distances[vertex] - m_end) < m_width_of_end;
  }

private:
  // Turns sections about the line such that they are not twisted against each other more than in the input. Returns a vector to the
  // front of a leg: where the foot points in the input, and a knee, away from what is bent there.
  Eigen::Vector3d align_with_rest(const Body_plan& body, const Limb& limb,
                                  const Point_matrix& points)
  {
    const std::size_t last = m_rotations.size() - 1;
    const auto rotation_to_rest = [&](const std::size_t k) {
      return body.rotation_to_rest(points, limb, m_end + (static_cast<double>(k) + .5) * m_length);
    };
    Eigen::Quaterniond to_rest = rotation_to_rest(last),
                       from_rest = m_rotations[last] * to_rest.conjugate();
    Eigen::Vector3d tangent_before = (to_rest * tangent(last)).normalized(),
                    bends = Eigen::Vector3d::Zero();
    for(std::size_t k = last; k-- > 0;)
    {
      to_rest = rotation_to_rest(k);
      const Eigen::Vector3d tangent_of_rest = (to_rest * tangent(k)).normalized();
      bends += from_rest * tangent_of_rest - m_direction;
      from_rest = from_rest * Eigen::Quaterniond::FromTwoVectors(tangent_of_rest, tangent_before);
      m_rotations[k] = from_rest * to_rest;
      tangent_before = tangent_of_rest;
    }
    const Point_matrix rest = body.rest();
    const Eigen::Vector3d foot
      = (rest.row(static_cast<Eigen::Index>(limb.tip)) - body.center(rest, limb, m_end))
          .transpose()
          .normalized();
    return from_rest * foot - bends;
  }

  // By which a vector is turned about a direction to be as near as possible to another one; 0 if either is almost in the direction.
  static double angle_about(const Eigen::Vector3d& direction, const Eigen::Vector3d& from,
                            const Eigen::Vector3d& to)
  {
    constexpr double least_share = .3;
    const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
      return v - v.dot(direction) * direction;
    };
    const Eigen::Vector3d a = across(from), b = across(to);
    if(a.norm() < least_share * from.norm() || b.norm() < least_share * to.norm())
      return 0;
    return std::atan2(a.cross(b).dot(direction), a.dot(b));
  }

  Eigen::Vector3d tangent(const std::size_t k) const { return m_centers[k] - m_centers[k + 1]; }

  Eigen::Vector3d moved(Eigen::Vector3d point, const double distance) const
  {
    if(distance < m_end)
      point += smooth_step((m_end - distance) / m_width_of_end) * (m_stretch_of_tip - 1)
               * (point - m_centers[0]).dot(m_along_tip) * m_along_tip;
    const double last = static_cast<double>(m_rotations.size()),
                 at = std::clamp((distance - m_end) / m_length, 0., last);
    const auto k = static_cast<std::size_t>((std::min)(at, last - 1));
    const double share = at - static_cast<double>(k);
    // Rotations are those of the middles of sections.
    const double between = std::clamp(at - .5, 0., last - 1);
    const auto r = static_cast<std::size_t>((std::min)(between, (std::max)(last - 2, 0.)));
    const Eigen::Quaterniond rotation = m_rotations[r].slerp(
      between - static_cast<double>(r), m_rotations[(std::min)(r + 1, m_rotations.size() - 1)]);
    const auto mixed = [&](const std::vector<Eigen::Vector3d>& values) {
      return Eigen::Vector3d((1 - share) * values[k] + share * values[k + 1]);
    };
    const double twist
      = m_twist * smooth_step((m_end + m_length * last - distance) / m_length_of_twist);
    return mixed(m_positions)
           + Eigen::AngleAxisd(twist, m_direction) * (rotation * (point - mixed(m_centers)));
  }

  const Eigen::VectorXd& m_distances;
  double m_end, m_width_of_end, m_length; // the last one: of a section
  Eigen::Vector3d m_direction, m_along_tip;
  double m_stretch_of_tip;
  double m_twist = 0, m_length_of_twist = 1;
  std::vector<Eigen::Vector3d> m_centers, m_positions; // from the end to the root
  std::vector<Eigen::Quaterniond> m_rotations;         // of the sections between them
  std::optional<Eigen::Quaterniond> m_rotation_of_tip;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_MOVED_LIMB_H
