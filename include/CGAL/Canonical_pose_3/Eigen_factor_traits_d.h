// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EIGEN_FACTOR_TRAITS_D_H
#define CGAL_CANONICAL_POSE_3_EIGEN_FACTOR_TRAITS_D_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/factor_failures.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/is_positive_pivot.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Eigen does not notice if there are more entries than its indices can count.
class Checked_ldlt : public Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>
{
  using Base = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

public:
  static constexpr const char* NAME = "Eigen SimplicialLDLT";

  Checked_ldlt& compute(const Eigen::SparseMatrix<double>& matrix)
  {
    const auto rows = static_cast<std::size_t>(matrix.rows());
    try
    {
      analyzePattern(matrix);
      check(m_matrix.outerIndexPtr(), rows);
      factorize(matrix);
    }
    catch(const std::bad_alloc&)
    {
      throw_out_of_memory(rows, NAME);
    }
    return *this;
  }

  // `begin`: of each column among the entries of the factor, and of the end; they may have overflowed.
  static void check(const int* begin, const std::size_t number_of_rows)
  {
    std::size_t number = 0;
    for(std::size_t j = 0; j < number_of_rows; ++j)
      number += static_cast<std::uint32_t>(begin[j + 1]) - static_cast<std::uint32_t>(begin[j]);
    if(number > static_cast<std::size_t>((std::numeric_limits<int>::max)()))
      throw_too_large(number_of_rows, NAME);
  }
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Eigen_factor_traits_d` solves sparse symmetric positive definite systems with
Eigen's `SimplicialLDLT`.

It requires only Eigen, and may be used from several threads at once. Its results do not depend on
the number of threads.

\cgalModels `SparseLinearAlgebraWithBlockFactorTraits_d`

\sa `CGAL::Canonical_pose_3::Cholmod_factor_traits_d`
\sa `CGAL::Canonical_pose_3::Default_factor_traits_d`
*/
class Eigen_factor_traits_d : public Eigen_solver_traits<internal::Checked_ldlt>
{
  using Base = Eigen_solver_traits<internal::Checked_ldlt>;

public:
  /// \name Types
  /// @{

  using NT = Base::NT;         ///< `double`
  using Vector = Base::Vector; ///< `CGAL::Eigen_vector<double>`
  using Matrix = Base::Matrix; ///< `CGAL::Eigen_sparse_matrix<double>`

  /// @}

  /// \name Operations
  /// @{

  /// factors `matrix`, reading only its lower triangle.
  /// \returns `false` if the matrix is not numerically positive definite: a pivot is not positive,
  /// not finite, or below 1e-14 times the original diagonal entry.
  /// \throws std::runtime_error if memory runs out, or the factor has more than \f$ 2^{31} - 1 \f$
  ///         entries.
  bool factor(const Matrix& matrix, NT& denominator)
  {
    m_is_factored = Base::factor(matrix, denominator) && has_positive_pivots(matrix);
    return m_is_factored;
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
    CGAL_precondition(m_is_factored);
    solution = m_solver_sptr->solve(right_hand_side);
    return solution.eigen_object().allFinite();
  }

  /// solves for a block of right-hand sides, one per column. Each column of the solution is bitwise
  /// equal to the solution of a single right-hand side.
  /// \returns `false` if the solution is not finite
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
                     Eigen::MatrixXd& solutions) const
  {
    CGAL_precondition(m_is_factored);
    solutions.resize(right_hand_sides.rows(), right_hand_sides.cols());
    if(solutions.size() > 0) // Eigen would add to a null pointer
      solutions = m_solver_sptr->solve(right_hand_sides);
    return solutions.allFinite();
  }

  /// returns "Eigen SimplicialLDLT".
  static const char* name() { return internal::Checked_ldlt::NAME; }

  /// @}

private:
  bool has_positive_pivots(const Matrix& matrix) const
  {
    const auto pivots = m_solver_sptr->vectorD();
    const Eigen::VectorXd diagonal
      = m_solver_sptr->permutationP() * Eigen::VectorXd(matrix.eigen_object().diagonal());
    for(Eigen::Index i = 0; i < pivots.size(); ++i)
      if(!internal::is_positive_pivot(pivots[i], diagonal[i]))
        return false;
    return true;
  }

  bool m_is_factored = false;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_EIGEN_FACTOR_TRAITS_D_H
