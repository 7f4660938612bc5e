// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_UPDATED_FACTOR_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_UPDATED_FACTOR_H

#include "Sparse_factor.h"

#include <CGAL/Canonical_pose_3/internal/linear_algebra/dense_products.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>

#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A factorization of a symmetric positive definite matrix A0 that also solves for A = A0 + U D U^t,
// where D is a small diagonal matrix, using the Woodbury identity:
//   A^{-1} = A0^{-1} - W (D^{-1} + S)^{-1} W^t,  W = A0^{-1} U,  S = U^t W.
// Entries of D may be of either sign.
class Updated_factor
{
public:
  explicit Updated_factor(const Factor_maker maker = make_default_factor) : m_factor(maker) {}

  // Factors A0 and forgets the update; see `Sparse_factor::factor()`.
  void factor(const Eigen::SparseMatrix<double>& matrix, const char* what)
  {
    forget_update();
    m_factor.factor(matrix, what);
  }

  void forget_update() { m_u.resize(0, 0); }

  // Replaces U and D. Returns false if A is not positive definite, or if its solutions would lose
  // more than six digits by cancellation (for instance if an element much stiffer than all others
  // is removed from A0); then there is no update. Costs one solve per row of D.
  bool update(const Eigen::SparseMatrix<double>& u, const Eigen::VectorXd& d)
  {
    forget_update();
    if(u.cols() == 0)
      return true;
    m_factor.solve(Eigen::MatrixXd(u), m_w);
    Eigen::MatrixXd s = u.transpose() * m_w;
    s = (s + s.transpose().eval()) / 2;
    const Eigen::MatrixXd inverse_of_d = d.cwiseInverse().asDiagonal();
    m_core = (inverse_of_d + s).partialPivLu().inverse();
    const double amplification = product(m_core.cwiseAbs(), inverse_of_d.cwiseAbs() + s.cwiseAbs())
                                   .rowwise()
                                   .sum()
                                   .maxCoeff();
    if(!(amplification <= LARGEST_AMPLIFICATION))
      return false;
    // A is positive definite if and only if I + R^t D R is, where R R^t = S
    const std::optional<Eigenpairs> spectrum = all_eigenpairs(s);
    if(!spectrum)
      return false;
    const Eigen::MatrixXd root
      = spectrum->vectors * spectrum->values.cwiseMax(0).cwiseSqrt().asDiagonal();
    Eigen::MatrixXd sum = product_of_transposed(root, d.asDiagonal() * root);
    sum.diagonal().array() += 1;
    const std::optional<Eigenpairs> spectrum_of_sum = all_eigenpairs(sum);
    if(!spectrum_of_sum || !(spectrum_of_sum->values[0] > 0))
      return false;
    m_u = u;
    return true;
  }

  // Solves for A, one right-hand side per column.
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
             Eigen::MatrixXd& solutions) const
  {
    m_factor.solve(right_hand_sides, solutions);
    if(m_u.cols() > 0)
    {
      const Eigen::MatrixXd displacements = m_u.transpose() * solutions;
      const Eigen::MatrixXd forces = product(m_core, displacements);
      solutions.noalias() -= m_w * forces;
    }
  }

  bool is_factored() const { return m_factor.is_factored(); }

  const char* name() const { return m_factor.name(); }

private:
  static constexpr double LARGEST_AMPLIFICATION = 1e6; // of rounding errors

  Sparse_factor m_factor;
  Eigen::SparseMatrix<double> m_u; // no columns if there is no update
  Eigen::MatrixXd m_w, m_core;     // W, (D^{-1} + S)^{-1}
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_UPDATED_FACTOR_H
