// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_BODY_PLAN_H
#define CANONICAL_POSE_3_ENGINE_STANCE_BODY_PLAN_H

#include "smooth_step.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Measures distances on a surface: from the given sources, or from landmarks that are spread over it.
using Measure_distances = std::function<Landmark_fields_3(const Surface_component_3& surface,
                                                          const std::vector<std::size_t>& sources)>;

// A limb in the canonical pose. Distances are measured from its tip.
struct Limb
{
  Eigen::VectorXd distances; // one per vertex
  std::size_t tip;           // the vertex with the smallest distance
  double end;                // the distance of wrist or ankle, or where the neck begins
  double root;               // that of shoulder or hip, or where the neck ends
};

// What is known of a body with two arms and two legs, or four legs: limbs, and a frame whose axes are left, up and front. Lengths
// are relative to the root of the area.
class Body_plan
{
public:
  // Refers to the surface. Throws std::invalid_argument if the shape has no such limbs. `pose`: one row per vertex of the surface.
  Body_plan(const Surface_component_3& surface, const Coarse_surface_3& coarse,
            const Point_matrix& pose, const Measure_distances& measure);

  Skeleton_3::Kind kind() const { return m_kind; }

  // Whether front and back, or up and down, can be told apart.
  bool is_certain() const { return m_is_certain; }

  double unit() const { return m_unit; } // the root of the area of the pose
  const Point_matrix& pose() const { return m_pose; }
  Point_matrix rest() const { return m_unit_of_rest / m_unit * m_rest; } // in the unit of the pose
  const Eigen::VectorXd& shares() const { return m_shares; }             // of the area

  // Left and right arms (or front legs), left and right legs (or hind legs).
  const std::array<Limb, 4>& limbs() const { return m_limbs; }

  const Limb& head() const { return m_others.front(); }
  const Limb* tail() const { return m_others.size() > 1 ? &m_others[1] : nullptr; }

  // The vertex of the head of an animal between left and right that is farthest along the neck and downward from it.
  std::size_t nose() const;

  // Between the joints of the legs.
  const Eigen::RowVector3d& origin() const { return m_origin; }

  // The direction of the head.
  const Eigen::RowVector3d& axis() const { return m_axis; }

  // From between the joints of the legs to between those of the arms.
  double length_of_trunk() const { return m_length_of_trunk; }

  // Rows: left, up, front, where the arms are (0), and where the legs are (1).
  const std::array<Eigen::Matrix3d, 2>& frames() const { return m_frames; }

  // The pose in the frame of the legs, with the origin between their joints.
  Point_matrix upright() const
  {
    return m_unit * (m_pose.rowwise() - m_origin) * m_frames[1].transpose();
  }

  // From 0 at the root of a limb, and outside of it, to 1 beyond the joint.
  double share_of_limb(const Limb& limb, const Eigen::Index vertex) const
  {
    return smooth_step((limb.root - limb.distances[vertex]) / (2 * width_of_joint(limb)));
  }

  // Of the trunk: from 0 at the hips to 1 at the chest.
  double share_of_chest(const Eigen::Index vertex) const
  {
    constexpr double first = .2, last = .8; // of the length of the trunk
    const double height = (m_pose.row(vertex) - m_origin).dot(m_axis) / m_length_of_trunk;
    return smooth_step((height - first) / (last - first));
  }

  // Half of the width in which joints of a limb are blended.
  static double width_of_joint(const Limb& limb) { return .1 * (std::min)(limb.root, 1.); }

  // The length around a limb at a distance.
  double girth(const Limb& limb, double distance) const;

  // The mean position of the vertices at a distance along a limb.
  Eigen::RowVector3d center(const Point_matrix& points, const Limb& limb, double distance,
                            double width = .04) const;

  // The rotation from `points`, a motion of the pose, to the input of a ring around a limb.
  Eigen::Quaterniond rotation_to_rest(const Point_matrix& points, const Limb& limb,
                                      double distance) const;

  // Wrist or ankle, or where the neck begins: on the line of the limb before it, since the skin around it is bent.
  Eigen::RowVector3d end_joint(const Point_matrix& points, const Limb& limb) const;

  // Whether the areas of two limbs are about the same in the input.
  bool is_like(const Limb& limb, const Limb& other) const;

  // How much directions in the pose are shorter or longer in the input, in each of several groups of triangles: the mean over triangles
  // of how vectors in the plane of each are stretched, which does not depend on how the shape is bent. `directions`: one per
  // group; `points`: a motion of the pose; `group_of`: the group for the mean of `values` in a triangle, or another number.
  std::vector<double>
  stretches_of_rest(const Point_matrix& points, const std::vector<Eigen::Vector3d>& directions,
                    const Eigen::VectorXd& values,
                    const std::function<std::size_t(double mean)>& group_of) const;

private:
  void find_limbs(const Coarse_surface_3& coarse, const Measure_distances& measure);
  void set_trunk();
  void set_joints();
  void check_proportions() const;
  void set_frames(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                  const Measure_distances& measure);
  bool are_legs_on_other_sides(const Coarse_surface_3& coarse,
                               const Measure_distances& measure) const;
  Eigen::RowVector3d joint(const Limb& limb) const { return center(m_pose, limb, limb.root); }
  Eigen::RowVector3d direction_across(std::size_t pair) const;
  Eigen::RowVector3d orthogonal_to_trunk(const Eigen::RowVector3d& direction) const
  {
    return (direction - direction.dot(m_axis) * m_axis).normalized();
  }
  Eigen::Vector3d direction_of_toes(const Limb& limb) const;
  Eigen::Vector3d direction_of_leg(const Limb& limb) const;

  const std::vector<std::array<std::size_t, 3>>& m_triangles;
  double m_unit, m_unit_of_rest;
  Point_matrix m_rest, m_pose;
  Eigen::VectorXd m_shares;
  Skeleton_3::Kind m_kind = Skeleton_3::Kind::PERSON;
  bool m_is_certain = false;
  std::array<Limb, 4> m_limbs;
  std::vector<Limb> m_others; // head and tail
  Eigen::RowVector3d m_origin, m_axis;
  double m_length_of_trunk = 0;
  std::array<Eigen::Matrix3d, 2> m_frames;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_BODY_PLAN_H
