// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_DENSE_PRODUCTS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_DENSE_PRODUCTS_H

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A B and A^t B, for any blocks of matrices: Eigen's products take long to compile, separately for
// each type of operand.
inline Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                               const Eigen::Ref<const Eigen::MatrixXd>& b)
{
  return a * b;
}

inline Eigen::MatrixXd product_of_transposed(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                             const Eigen::Ref<const Eigen::MatrixXd>& b)
{
  return a.transpose() * b;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_DENSE_PRODUCTS_H
