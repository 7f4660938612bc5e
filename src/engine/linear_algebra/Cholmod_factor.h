// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_FACTOR_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_FACTOR_H

#include "Cholmod_workspace.h"
#include "../support/state_of_the_process.h"

#include <CGAL/Canonical_pose_3/internal/linear_algebra/is_positive_pivot.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cholmod.h>

#include <cstddef>
#include <memory>
#include <mutex>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Cholmod_factor_pointer = std::shared_ptr<cholmod_factor>;

inline Cholmod_factor_pointer own_cholmod_factor(cholmod_factor* factor)
{
  return Cholmod_factor_pointer(factor, [](cholmod_factor* f) {
    Cholmod_common common;
    cholmod_l_free_factor(&f, common.get());
  });
}

// Of factors, which may have more than 2^31 entries.
using Factor_index = std::ptrdiff_t;
using Cholmod_matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Factor_index>;
static_assert(sizeof(Factor_index) == sizeof(SuiteSparse_long),
              "indices of CHOLMOD have another size");

// A view of the lower triangle of a compressed matrix; CHOLMOD does not write to it.
inline cholmod_sparse lower_triangle(const Cholmod_matrix& matrix)
{
  cholmod_sparse view = {};
  view.nrow = static_cast<std::size_t>(matrix.rows());
  view.ncol = static_cast<std::size_t>(matrix.cols());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = const_cast<Factor_index*>(matrix.outerIndexPtr());
  view.i = const_cast<Factor_index*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_LONG;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

// The symbolic factor, in CHOLMOD's default order: that of AMD, or that of METIS if AMD is not good
// and METIS is better. CHOLMOD itself would call METIS from several threads at the same time.
// Null for a matrix without entries.
inline Cholmod_factor_pointer analyzed(cholmod_sparse& matrix, Cholmod_common& common)
{
  cholmod_common& c = *common.get();
  c.nmethods = 1;
  c.method[0].ordering = CHOLMOD_AMD;
  Cholmod_factor_pointer by_amd = own_cholmod_factor(cholmod_l_analyze(&matrix, &c));
  if(by_amd == nullptr)
  {
    common.check(matrix.nrow);
    return nullptr;
  }
  if(c.fl < 500 * c.lnz || c.lnz < 5 * c.anz)
    return by_amd;
  const double nonzeros = c.lnz;
  c.method[0].ordering = CHOLMOD_METIS;
  const std::lock_guard<std::mutex> lock(mutex_of_random_numbers());
  Cholmod_factor_pointer by_metis = own_cholmod_factor(cholmod_l_analyze(&matrix, &c));
  return by_metis != nullptr && c.lnz < nonzeros ? by_metis : by_amd;
}

// Factors a matrix that was analyzed. Returns false if it is not numerically positive definite, and
// throws if it cannot be factored for another reason.
inline bool factorize(cholmod_sparse& matrix, cholmod_factor* factor, Cholmod_common& common)
{
  if(factor->is_super != 0)
  {
    // OpenBLAS tries without end to allocate its buffer of 128 MB.
    constexpr std::size_t bytes = std::size_t(160) << 20;
    void* const memory = cholmod_l_malloc(bytes, 1, common.get());
    common.check(matrix.nrow);
    cholmod_l_free(bytes, 1, memory, common.get());
  }
  const bool is_factored = cholmod_l_factorize(&matrix, factor, common.get()) != 0;
  common.check(matrix.nrow);
  return is_factored && factor->minor == factor->n;
}

// `factor`: LDL', column by column; `diagonal`: that of the matrix, in its original order.
inline bool has_positive_pivots(const cholmod_factor& factor, const Eigen::VectorXd& diagonal)
{
  const auto* const values = static_cast<const double*>(factor.x);
  const auto* const order = static_cast<const Factor_index*>(factor.Perm);
  const auto is_positive
    = [&](Factor_index j, double pivot) { return is_positive_pivot(pivot, diagonal[order[j]]); };
  const auto* const starts = static_cast<const Factor_index*>(factor.p);
  for(Factor_index j = 0; j < static_cast<Factor_index>(factor.n); ++j)
    if(!is_positive(j, values[starts[j]]))
      return false;
  return true;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_FACTOR_H
