// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_CHIRALITY_H
#define CANONICAL_POSE_3_ENGINE_TARGET_CHIRALITY_H

#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_CHIRALITY_H
