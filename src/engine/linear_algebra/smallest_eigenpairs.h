// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SMALLEST_EIGENPAIRS_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SMALLEST_EIGENPAIRS_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>

#include <Eigen/Core>

#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The smallest eigenvalues of a symmetric matrix, in increasing order, and their eigenvectors; nothing
// if they could not be computed. For few of them, a third of the time for all.
std::optional<Eigenpairs> smallest_eigenpairs(const Eigen::MatrixXd& matrix, Eigen::Index count);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SMALLEST_EIGENPAIRS_H
