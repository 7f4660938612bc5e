// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_IS_POSITIVE_PIVOT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_IS_POSITIVE_PIVOT_H

#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Pivots of a factorization are the remainders of the diagonal of the matrix; for a singular
// matrix, they are rounding errors of either sign.
inline constexpr double SMALLEST_RELATIVE_PIVOT = 1e-14;

// also false if one of the two is not finite
inline bool is_positive_pivot(double pivot, double diagonal_entry)
{
  return pivot > 0 && pivot >= SMALLEST_RELATIVE_PIVOT * diagonal_entry && std::isfinite(pivot);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_IS_POSITIVE_PIVOT_H
