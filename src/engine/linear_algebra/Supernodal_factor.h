// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H

#include "Cholmod_factor.h"
#include "Cholmod_supernodes.h"
#include "Supernodal_routines.h"
#include "../support/state_of_the_process.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cholmod.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// CHOLMOD's supernodal factor of a symmetric positive definite matrix, with our own substitutions
// for eight right-hand sides. They take a fraction of the time of CHOLMOD's, and a column has the
// same bytes independently of the others. Rows are in elimination order.
class Supernodal_factor
{
public:
  // Analyzes the pattern. Copies made afterwards share the analysis, and can be given another matrix
  // with this pattern, which is not empty.
  void analyze(const Eigen::SparseMatrix<double>& matrix)
  {
    Cholmod_common common;
    common.get()->supernodal = CHOLMOD_SUPERNODAL;
    // Columns are merged into blocks unless this adds too many zeros: more zeros make factoring
    // faster, but each substitution slower.
    common.get()->zrelax[0] = 0.3;
    const Cholmod_matrix copy = matrix;
    cholmod_sparse view = lower_triangle(copy);
    m_analysis = analyzed(view, common);
  }

  // Reads the lower triangle of the matrix. Returns false if the matrix is not numerically positive
  // definite.
  bool factor(const Eigen::SparseMatrix<double>& matrix)
  {
    const Single_threaded_blas guard;
    const Openmp_off no_openmp;
    Cholmod_common common;
    common.get()->supernodal = CHOLMOD_SUPERNODAL;
    const Cholmod_matrix copy = matrix;
    cholmod_sparse view = lower_triangle(copy);
    const Cholmod_factor_pointer result
      = own_cholmod_factor(cholmod_l_copy_factor(m_analysis.get(), common.get()));
    if(result == nullptr)
      common.check(m_analysis->n);
    if(!factorize(view, result.get(), common) || !has_positive_pivots(*result, matrix.diagonal()))
      return false;
    m_supernodes = Cholmod_supernodes(result);
    return true;
  }

  // The row of the factor for each row of the matrix.
  std::vector<int> places() const
  {
    const auto* const order = static_cast<const Factor_index*>(m_analysis->Perm);
    std::vector<int> result(m_analysis->n);
    for(std::size_t i = 0; i < result.size(); ++i)
      result[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    return result;
  }

  // Solves in place, for `rows` in elimination order. Rows that are 0 in all lanes have little
  // cost.
  void solve(Lane_rows& rows, std::size_t) const
  {
    const Supernodal_matrix matrix = m_supernodes.matrix();
    run_routine<Forward_substitution>(&matrix, rows.data());
    run_routine<Backward_substitution>(&matrix, rows.data());
  }

  static const char* name() { return "CHOLMOD"; }

private:
  Cholmod_factor_pointer m_analysis;
  Cholmod_supernodes m_supernodes;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H
