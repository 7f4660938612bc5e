// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CHOLMOD_FACTOR_TRAITS_D_H
#define CGAL_CANONICAL_POSE_3_CHOLMOD_FACTOR_TRAITS_D_H

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/Core>

#include <memory>

struct cholmod_factor_struct; // of CHOLMOD

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Cholmod_factor_traits_d` solves sparse symmetric positive definite systems with
CHOLMOD of SuiteSparse; it factors column by column or in dense blocks, whichever is faster for the
matrix.

It exists if the library was built with CHOLMOD; otherwise, programs that use it do not link. It
prints nothing. Copies share one factorization.

Its results do not depend on the number of threads: inside its functions, OpenBLAS and OpenMP are
temporarily limited to one thread, and the columns of a block are solved independently, three at a
time (in parallel, if the library was built with TBB). It may be used from several threads at once.

\cgalModels `SparseLinearAlgebraWithBlockFactorTraits_d`

\sa `CGAL::Canonical_pose_3::Eigen_factor_traits_d`
\sa `CGAL::Canonical_pose_3::Default_factor_traits_d`
*/
class Cholmod_factor_traits_d
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
  /// \returns `false` if the matrix is not numerically positive definite: a pivot is not positive,
  /// not finite, or below 1e-14 times the original diagonal entry.
  /// \throws std::runtime_error if memory runs out
  bool factor(const Matrix& matrix, NT& denominator);

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

  /// solves for a block of right-hand sides, one per column. Each column of the solution is bitwise
  /// equal to the solution of a single right-hand side.
  /// \returns `false` if the solution is not finite
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
                     Eigen::MatrixXd& solutions) const;

  /// returns "CHOLMOD".
  static const char* name() { return "CHOLMOD"; }

  /// @}

private:
  std::shared_ptr<cholmod_factor_struct> m_factor;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CHOLMOD_FACTOR_TRAITS_D_H
