// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_DEFAULT_FACTOR_TRAITS_D_H
#define CGAL_CANONICAL_POSE_3_DEFAULT_FACTOR_TRAITS_D_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Default_factor_traits_d` solves sparse symmetric positive definite systems with
`Cholmod_factor_traits_d` if the library was built with CHOLMOD, and with `Eigen_factor_traits_d`
otherwise. Copies share one factorization.

\cgalModels `SparseLinearAlgebraWithBlockFactorTraits_d`
*/
class Default_factor_traits_d
{
public:
  /// \name Types
  /// @{

  using NT = double;                                ///< the number type
  using Vector = CGAL::Eigen_vector<double>;        ///< the vector type
  using Matrix = CGAL::Eigen_sparse_matrix<double>; ///< the matrix type
  using Index = Eigen::Index;                       ///< the type of row and column indices

  /// @}

  /// \name Operations
  /// @{

  /// factors `matrix`, reading only its lower triangle.
  /// \returns `false` if the matrix is not numerically positive definite.
  bool factor(const Matrix& matrix, NT& denominator)
  {
    denominator = 1;
    std::shared_ptr<internal::Factor_base> result = internal::make_default_factor();
    m_factor = result->factor(matrix.eigen_object()) ? result : nullptr;
    return m_factor != nullptr;
  }

  /// factors `matrix` and solves for one right-hand side.
  bool linear_solver(const Matrix& matrix, const Vector& right_hand_side, Vector& solution,
                     NT& denominator)
  {
    return factor(matrix, denominator) && linear_solver(right_hand_side, solution);
  }

  /// solves for one right-hand side, with the last matrix passed to `factor()`.
  bool linear_solver(const Vector& right_hand_side, Vector& solution) const
  {
    Eigen::MatrixXd solutions;
    const bool solved = linear_solver(right_hand_side.eigen_object(), solutions);
    solution.eigen_object() = solutions;
    return solved;
  }

  /// solves for a block of right-hand sides, one per column.
  /// \returns `false` if the solution is not finite
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
                     Eigen::MatrixXd& solutions) const
  {
    CGAL_precondition(m_factor != nullptr);
    return m_factor->solve(right_hand_sides, solutions);
  }

  /// returns "CHOLMOD" or "Eigen".
  static const char* name() { return internal::make_default_factor()->name(); }

  /// @}

private:
  std::shared_ptr<const internal::Factor_base> m_factor;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DEFAULT_FACTOR_TRAITS_D_H
