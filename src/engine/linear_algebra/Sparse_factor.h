// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SPARSE_FACTOR_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SPARSE_FACTOR_H

#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/factor_failures.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A factorization of a symmetric positive definite matrix, for any number of solves.
// Solving is const and can be done in several threads at the same time.
class Sparse_factor
{
public:
  explicit Sparse_factor(const Factor_maker maker = make_default_factor) : m_solver(maker()) {}

  // `matrix`: full symmetric (or its lower triangle); `what`: its name in messages. Throws
  // `Ill_conditioned` if the matrix is not positive definite; then nothing is factored.
  void factor(const Eigen::SparseMatrix<double>& matrix, const char* what)
  {
    CANONICAL_POSE_3_PRECONDITION(matrix.rows() == matrix.cols());
    m_what = what;
    m_size = -1;
    if(!m_solver->factor(matrix))
      throw Ill_conditioned(m_what + " is not positive definite (" + name() + ")");
    m_size = matrix.rows();
  }

  // `right_hand_sides`: one per column, with as many rows as the matrix. Each column of the
  // solution has the same bytes independently of the others.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const
  {
    Eigen::MatrixXd solutions;
    solve(right_hand_sides, solutions);
    return solutions;
  }

  // The same, written to `solutions`, which is reallocated only if its size differs.
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
             Eigen::MatrixXd& solutions) const
  {
    CANONICAL_POSE_3_PRECONDITION(is_factored());
    CANONICAL_POSE_3_PRECONDITION(right_hand_sides.rows() == m_size);
    solutions.resize(right_hand_sides.rows(), right_hand_sides.cols());
    if(!m_solver->solve(right_hand_sides, solutions) || !solutions.allFinite())
      throw Ill_conditioned("a solution for " + m_what + " is not finite (" + name() + ")");
  }

  bool is_factored() const { return m_size >= 0; }

  const char* name() const { return m_solver->name(); }

private:
  std::unique_ptr<Factor_base> m_solver;
  std::string m_what;
  Eigen::Index m_size = -1;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SPARSE_FACTOR_H
