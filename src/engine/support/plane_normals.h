// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_PLANE_NORMALS_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_PLANE_NORMALS_H

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Of planes that are orthogonal to a principal axis, or contain one and halve the angle of the
// others: those of reflections that are tried for a symmetric shape.
inline std::vector<Eigen::Vector3d> plane_normals(const Eigen::Matrix3d& axes)
{
  std::vector<Eigen::Vector3d> result;
  for(Eigen::Index i = 0; i < 3; ++i)
  {
    result.push_back(axes.col(i));
    for(Eigen::Index j = 0; j < i; ++j)
    {
      result.push_back((axes.col(i) + axes.col(j)).normalized());
      result.push_back((axes.col(i) - axes.col(j)).normalized());
    }
  }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_PLANE_NORMALS_H
