// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_FACTOR_FAILURES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_FACTOR_FAILURES_H

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A system of equations that cannot be solved because of its numbers.
class Ill_conditioned : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Reasons why a matrix cannot be factored although it may be positive definite.

[[noreturn]] inline void throw_too_large(const std::size_t number_of_rows, const char* solver)
{
  throw std::runtime_error("the factor of a matrix with " + std::to_string(number_of_rows)
                           + " rows is too large: it has more than "
                           + std::to_string((std::numeric_limits<int>::max)()) + " entries ("
                           + solver + ")");
}

[[noreturn]] inline void throw_out_of_memory(const std::size_t number_of_rows, const char* solver)
{
  throw std::runtime_error("there is not enough memory for the factor of a matrix with "
                           + std::to_string(number_of_rows) + " rows (" + solver + ")");
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_FACTOR_FAILURES_H
