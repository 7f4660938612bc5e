// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_CLOSEST_ROTATION_OF_POINTS_H
#define CANONICAL_POSE_3_ENGINE_STANCE_CLOSEST_ROTATION_OF_POINTS_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The rotation, about centroids, that brings points as near as possible to others; rows are points.
inline Eigen::Matrix3d closest_rotation_of_points(const Point_matrix& points,
                                                  const Point_matrix& others,
                                                  const Eigen::VectorXd& weights)
{
  const double sum = weights.sum();
  if(!(sum > 0))
    return Eigen::Matrix3d::Identity();
  const Eigen::RowVector3d center = weights.transpose() * points / sum,
                           center_of_others = weights.transpose() * others / sum;
  const Eigen::Matrix3d moments = (others.rowwise() - center_of_others).transpose()
                                  * weights.asDiagonal() * (points.rowwise() - center);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_CLOSEST_ROTATION_OF_POINTS_H
