// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_CHIRALITY_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_CHIRALITY_H

#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Returns sum m x y z along the principal axes, the longest first, as a right-handed frame, divided
// by the product of the standard deviations; 0 for flat point sets. Reversing two axes does not
// change it, reversing one or three changes the sign.
inline double chirality(const Point_matrix& points, const Eigen::VectorXd& weights)
{
  const Principal_axes frame(points, weights);
  if(!(frame.variances[2] > 1e-10 * frame.variances[0]))
    return 0;
  const Point_matrix along_axes = (points.rowwise() - frame.centroid) * frame.axes;
  const double moment = along_axes.rowwise().prod().dot(weights) / weights.sum();
  return frame.axes.determinant() * moment / frame.variances.cwiseSqrt().prod();
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_CHIRALITY_H
