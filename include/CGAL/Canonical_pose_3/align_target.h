// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_ALIGN_TARGET_H
#define CGAL_CANONICAL_POSE_3_ALIGN_TARGET_H

#include <CGAL/Canonical_pose_3/internal/energy/closest_rotation.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>
#include <CGAL/assertions.h>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief moves a target rigidly onto the points it belongs to, after a reflection if requested, and
returns it.

Translation and rotation minimize \f$ \sum_i m_i |R x_i + t - p_i|^2 \f$
\cgalCite{cgal:canonical-k-sbrrsv-76}. The target is never scaled: its scale comes from the geodesic
distances, so that it does not depend on the pose. The signs of the axes of a multidimensional
scaling are arbitrary; `target_handedness()` tells which reflection to take.

\param target \f$ n \times 3 \f$, target \f$ x_i \f$ of each point.
\param points \f$ n \times 3 \f$, points \f$ p_i \f$.
\param weights \f$ n \f$ non-negative weights \f$ m_i \f$, for instance `vertex_area_shares()`.
\param mirrored whether the target is reflected before it is moved.

\pre The numbers of rows agree, and the sum of the weights is positive.

<em>Complexity:</em> linear.
*/
inline Point_matrix align_target(const Point_matrix& target, const Point_matrix& points,
                                 const Eigen::VectorXd& weights, const bool mirrored = false)
{
  CGAL_precondition(target.rows() == points.rows() && weights.size() == points.rows());
  CGAL_precondition(weights.sum() > 0);
  const Eigen::VectorXd share = weights / weights.sum();
  const Eigen::RowVector3d target_mean = share.transpose() * target;
  const Eigen::RowVector3d point_mean = share.transpose() * points;
  Point_matrix moved = target.rowwise() - target_mean;
  if(mirrored)
    moved.col(2) *= -1;
  const Eigen::Matrix3d covariance
    = (points.rowwise() - point_mean).transpose() * share.asDiagonal() * moved;
  // Normalized, as the models compare determinants and entries with absolute bounds.
  const double size = covariance.cwiseAbs().maxCoeff();
  const Eigen::Matrix3d rotation
    = size > 0 ? internal::rotation_by_traits<Deformation_Eigen_closest_rotation_traits_3>(
        covariance / size)
               : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  moved = moved * rotation.transpose();
  moved.rowwise() += point_mean;
  return moved;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_ALIGN_TARGET_H
