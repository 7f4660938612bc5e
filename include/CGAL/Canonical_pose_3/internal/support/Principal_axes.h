// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_PRINCIPAL_AXES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_PRINCIPAL_AXES_H

#include <CGAL/Canonical_pose_3/internal/support/weighted_product.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Eigenvalues>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The frame of weighted points: centroid, and principal axes as columns, the longest first.
struct Principal_axes
{
  Principal_axes(const Point_matrix& points, const Eigen::VectorXd& weights)
  {
    const Eigen::VectorXd share = weights / weights.sum();
    centroid = share.transpose() * points;
    const Point_matrix centered = points.rowwise() - centroid;
    const Eigen::Matrix3d covariance = weighted_product(centered, share, centered);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    axes = solver.eigenvectors().rowwise().reverse();
    variances = solver.eigenvalues().reverse();
  }

  // Orients the first two axes such that the third moments along them are not negative, and the
  // last one such that the frame is right-handed.
  void orient(const Point_matrix& points, const Eigen::VectorXd& weights)
  {
    const Point_matrix along_axes = (points.rowwise() - centroid) * axes;
    for(Eigen::Index k = 0; k < 2; ++k)
      if(along_axes.col(k).array().cube().matrix().dot(weights) < 0)
        axes.col(k) *= -1;
    axes.col(2) = axes.col(0).cross(axes.col(1));
  }

  Eigen::RowVector3d centroid;
  Eigen::Matrix3d axes;
  Eigen::Vector3d variances;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_PRINCIPAL_AXES_H
