// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LEADING_EIGENVECTORS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LEADING_EIGENVECTORS_H

#include <Eigen/Core>

#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Eigenvalues of a symmetric matrix, and their eigenvectors.
struct Eigenpairs
{
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// All of them, in increasing order, or nothing if they could not be computed.
std::optional<Eigenpairs> all_eigenpairs(const Eigen::MatrixXd& matrix);

// The largest, in decreasing order, by full decomposition. Throws `std::runtime_error` on failure.
Eigenpairs largest_of_all_eigenpairs(const Eigen::MatrixXd& matrix, Eigen::Index count);

// The same, using the Krylov space of a block, which has at least as many columns, since
// eigenvalues may be multiple; by full decomposition if this space grows to half of the whole.
Eigenpairs leading_eigenpairs(const Eigen::MatrixXd& matrix, Eigen::Index count);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LEADING_EIGENVECTORS_H
