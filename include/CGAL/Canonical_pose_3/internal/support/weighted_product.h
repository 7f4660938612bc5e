// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_WEIGHTED_PRODUCT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_WEIGHTED_PRODUCT_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The weighted sum of the products of each row of `a`, transposed, and the same row of `b`.
inline Eigen::Matrix3d weighted_product(const Point_matrix& a, const Eigen::VectorXd& weights,
                                        const Point_matrix& b)
{
  return a.transpose() * weights.asDiagonal() * b;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_WEIGHTED_PRODUCT_H
