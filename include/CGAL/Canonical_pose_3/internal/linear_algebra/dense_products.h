// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_DENSE_PRODUCTS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_DENSE_PRODUCTS_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
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
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_DENSE_PRODUCTS_H
