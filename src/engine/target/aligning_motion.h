// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_ALIGNING_MOTION_H
#define CANONICAL_POSE_3_ENGINE_TARGET_ALIGNING_MOTION_H

#include <CGAL/Canonical_pose_3/internal/support/rotation_by_traits.h>
#include <CGAL/Canonical_pose_3/internal/support/weighted_product.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The rotation that brings points as near as possible to others, both with the centroid 0; rows are points. The identity if
// the shares are not finite.
inline Eigen::Matrix3d aligning_rotation(const Point_matrix& points, const Point_matrix& others,
                                         const Eigen::VectorXd& shares)
{
  const Eigen::Matrix3d covariance = weighted_product(others, shares, points);
  // Normalized, since the models compare determinants and entries to absolute bounds.
  const double size = covariance.cwiseAbs().maxCoeff();
  return size > 0
           ? rotation_by_traits<Deformation_Eigen_closest_rotation_traits_3>(covariance / size)
           : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

// The rigid motion that does so; its rotation is the identity if no weight is positive.
inline Eigen::Isometry3d aligning_motion(const Point_matrix& points, const Point_matrix& others,
                                         const Eigen::VectorXd& weights)
{
  const Eigen::VectorXd shares = weights / weights.sum();
  const Eigen::RowVector3d mean = shares.transpose() * points,
                           mean_of_others = shares.transpose() * others;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear()
    = aligning_rotation(points.rowwise() - mean, others.rowwise() - mean_of_others, shares);
  result.translation() = mean_of_others.transpose() - result.linear() * mean.transpose();
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_ALIGNING_MOTION_H
