// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_CHOLMOD_FACTOR_TRAITS_D_H
#define CGAL_CANONICAL_POSE_3_CHOLMOD_FACTOR_TRAITS_D_H

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Cholmod_factor.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Cholmod_workspace.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Supernodal_column_solver.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/state_of_the_process.h>
#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cholmod.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Cholmod_factor_traits_d` solves sparse symmetric positive definite systems with
CHOLMOD of SuiteSparse, simplicial or supernodal, whichever is faster for the matrix.

It is available if the CMake target of the package has found CHOLMOD and defines the macro
`CGAL_CANONICAL_POSE_3_USE_CHOLMOD`. It prints nothing. Copies share one factorization.

Its results do not depend on the number of threads: inside its functions, OpenBLAS and OpenMP are
temporarily limited to one thread, and the columns of a block are solved independently, three at a
time (in parallel, if `CGAL_LINKED_WITH_TBB` is defined). It may be used from several threads at once.

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
  bool factor(const Matrix& matrix, NT& denominator)
  {
    denominator = 1;
    m_factor.reset();
    m_solver.reset();
    const internal::Single_threaded_blas guard;
    const internal::Openmp_off no_openmp;
    internal::Cholmod_common common;
    const internal::Cholmod_matrix compressed = matrix.eigen_object();
    cholmod_sparse view = internal::lower_triangle(compressed);
    const auto result = internal::analyzed(view, common);
    if(result == nullptr || !internal::factorize(view, result.get(), common)
       || !internal::has_positive_pivots(*result, compressed.diagonal()))
      return false;
    m_factor = result;
    if(m_factor->is_super)
      m_solver = std::make_shared<const internal::Supernodal_column_solver>(m_factor);
    return true;
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

  /// solves for a block of right-hand sides, one per column. Each column of the solution is bitwise
  /// equal to the solution of a single right-hand side.
  /// \returns `false` if the solution is not finite
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
                     Eigen::MatrixXd& solutions) const
  {
    CGAL_precondition(m_factor != nullptr);
    const internal::Single_threaded_blas guard;
    solutions.resize(right_hand_sides.rows(), right_hand_sides.cols());
    std::atomic<bool> solved(true);
    // CHOLMOD's simplicial solves sum in the same order for one to three columns.
    constexpr Index width = internal::NUMBER_OF_COORDINATES;
    const auto solve_groups = [&](Index first, Index last) {
      internal::Cholmod_workspace workspace;
      for(Index k = first * width; k < (std::min)(last * width, solutions.cols()); k += width)
      {
        const Index columns = (std::min)(width, solutions.cols() - k);
        const auto group = right_hand_sides.middleCols(k, columns);
        auto result = solutions.middleCols(k, columns);
        if(!(m_solver ? m_solver->solve(group, result)
                      : workspace.solve(m_factor.get(), group, result)))
          solved = false;
      }
    };
    const Index number_of_groups = (right_hand_sides.cols() + width - 1) / width;
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(
      tbb::blocked_range<Index>(0, number_of_groups),
      [&](const tbb::blocked_range<Index>& r) { solve_groups(r.begin(), r.end()); });
#else
    solve_groups(0, number_of_groups);
#endif
    return solved;
  }

  /// returns "CHOLMOD".
  static const char* name() { return "CHOLMOD"; }

  /// @}

private:
  internal::Cholmod_factor_pointer m_factor;
  std::shared_ptr<const internal::Supernodal_column_solver> m_solver; // if the factor is supernodal
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CHOLMOD_FACTOR_TRAITS_D_H
