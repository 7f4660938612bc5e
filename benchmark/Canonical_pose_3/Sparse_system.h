// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_SPARSE_SYSTEM_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_SPARSE_SYSTEM_H

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <stdexcept>

namespace Canonical_pose_benchmark {

/// A symmetric positive definite matrix, factored by the default solver of the package.
class Sparse_system
{
public:
  explicit Sparse_system(const Eigen::SparseMatrix<double>& matrix)
  {
    Factor_traits::NT denominator;
    if(!m_traits.factor(Factor_traits::Matrix(matrix), denominator))
      throw std::runtime_error("a matrix is not positive definite");
  }

  /// One right-hand side per column.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const
  {
    Eigen::MatrixXd solutions;
    if(!m_traits.linear_solver(right_hand_sides, solutions))
      throw std::runtime_error("a solution is not finite");
    return solutions;
  }

private:
  using Factor_traits = CGAL::Canonical_pose_3::Default_factor_traits_d;

  Factor_traits m_traits;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_SPARSE_SYSTEM_H
