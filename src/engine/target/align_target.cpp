// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligning_motion.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Canonical_pose_3 {

Point_matrix align_target(const Point_matrix& target, const Point_matrix& points,
                          const Eigen::VectorXd& weights, const bool mirrored)
{
  CANONICAL_POSE_3_PRECONDITION(target.rows() == points.rows() && weights.size() == points.rows());
  CANONICAL_POSE_3_PRECONDITION(weights.sum() > 0);
  const Eigen::VectorXd share = weights / weights.sum();
  const Eigen::RowVector3d target_mean = share.transpose() * target;
  const Eigen::RowVector3d point_mean = share.transpose() * points;
  Point_matrix moved = target.rowwise() - target_mean;
  if(mirrored)
    moved.col(2) *= -1;
  moved
    = moved * internal::aligning_rotation(moved, points.rowwise() - point_mean, share).transpose();
  moved.rowwise() += point_mean;
  return moved;
}

} // namespace Canonical_pose_3
} // namespace CGAL
