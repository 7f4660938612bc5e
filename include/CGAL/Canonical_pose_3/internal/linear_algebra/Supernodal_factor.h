// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Cholmod_factor.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Supernodal_routines.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/state_of_the_process.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cholmod.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// CHOLMOD's supernodal factor of a symmetric positive definite matrix, with our own substitutions
// for eight right-hand sides. They take a fraction of the time of CHOLMOD's, and a column has the
// same bytes independently of the others. Rows are in elimination order.
class Supernodal_factor
{
public:
  // Analyzes the pattern; returns false if out of memory. Copies made afterwards share the
  // analysis, and can be given another matrix with this pattern.
  bool analyze(const Eigen::SparseMatrix<double>& matrix)
  {
    Cholmod_common common;
    common.get()->supernodal = CHOLMOD_SUPERNODAL;
    // Columns are merged into blocks unless this adds too many zeros: more zeros make factoring
    // faster, but each substitution slower.
    common.get()->zrelax[0] = 0.3;
    cholmod_sparse view = lower_triangle(matrix);
    m_analysis = analyzed(view, common);
    return m_analysis != nullptr;
  }

  // Reads the lower triangle of the matrix. Returns false if the matrix is not numerically positive
  // definite, or if out of memory.
  bool factor(const Eigen::SparseMatrix<double>& matrix)
  {
    const Single_threaded_blas guard;
    const Openmp_off no_openmp;
    Cholmod_common common;
    common.get()->supernodal = CHOLMOD_SUPERNODAL;
    cholmod_sparse view = lower_triangle(matrix);
    m_factor = own_cholmod_factor(cholmod_copy_factor(m_analysis.get(), common.get()));
    if(m_factor == nullptr || !cholmod_factorize(&view, m_factor.get(), common.get())
       || m_factor->minor < m_factor->n || !has_positive_pivots(*m_factor, matrix.diagonal()))
      return false;
    set_inverse_diagonal();
    return true;
  }

  // The row of the factor for each row of the matrix.
  std::vector<int> places() const
  {
    const auto* const order = static_cast<const int*>(m_analysis->Perm);
    std::vector<int> result(m_analysis->n);
    for(std::size_t i = 0; i < result.size(); ++i)
      result[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    return result;
  }

  // Solves in place, for `rows` in elimination order. Rows that are 0 in all lanes have little
  // cost.
  void solve(Lane_rows& rows, std::size_t) const
  {
    const Supernodal_matrix matrix = view();
    run_routine<Forward_substitution>(&matrix, rows.data());
    run_routine<Backward_substitution>(&matrix, rows.data());
  }

  static const char* name() { return "CHOLMOD"; }

private:
  Supernodal_matrix view() const
  {
    return {m_factor->nsuper,
            static_cast<const int*>(m_factor->super),
            static_cast<const int*>(m_factor->pi),
            static_cast<const int*>(m_factor->px),
            static_cast<const int*>(m_factor->s),
            static_cast<const double*>(m_factor->x),
            m_inverse_diagonal.data()};
  }

  void set_inverse_diagonal()
  {
    m_inverse_diagonal.resize(m_factor->n);
    const Supernodal_matrix matrix = view();
    for(std::size_t s = 0; s < matrix.number_of_blocks; ++s)
    {
      const Supernode node(matrix, s);
      for(std::size_t j = 0; j < node.columns; ++j)
        m_inverse_diagonal[node.first + j] = 1 / node.values[j * (node.stride + 1)];
    }
  }

  Cholmod_factor_pointer m_analysis, m_factor;
  std::vector<double> m_inverse_diagonal;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H
