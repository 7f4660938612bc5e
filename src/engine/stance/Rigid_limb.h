// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_RIGID_LIMB_H
#define CANONICAL_POSE_3_ENGINE_STANCE_RIGID_LIMB_H

#include "Body_plan.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A limb that is turned about its root as it is, from there to its end in a direction, if there is one.
class Rigid_limb
{
public:
  Rigid_limb(const Body_plan& body, const Limb& limb, const Point_matrix& points,
             const std::optional<Eigen::Vector3d>& direction)
    : m_root(body.center(points, limb, limb.root).transpose())
  {
    if(direction)
      m_rotation.setFromTwoVectors(body.end_joint(points, limb).transpose() - m_root, *direction);
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& point, Eigen::Index) const
  {
    return m_root + m_rotation * (point - m_root);
  }

  static bool is_in_end(Eigen::Index) { return false; }

private:
  Eigen::Vector3d m_root;
  Eigen::Quaterniond m_rotation = Eigen::Quaterniond::Identity();
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_RIGID_LIMB_H
