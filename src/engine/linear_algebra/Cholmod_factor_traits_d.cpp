// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD

#include "Cholmod_factor.h"
#include "Cholmod_workspace.h"
#include "../support/state_of_the_process.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

bool Cholmod_factor_traits_d::factor(const Matrix& matrix, NT& denominator)
{
  denominator = 1;
  m_factor.reset();
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
  return true;
}

bool Cholmod_factor_traits_d::linear_solver(
  const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides, Eigen::MatrixXd& solutions) const
{
  CANONICAL_POSE_3_PRECONDITION(m_factor != nullptr);
  const internal::Single_threaded_blas guard;
  solutions.resize(right_hand_sides.rows(), right_hand_sides.cols());
  std::atomic<bool> solved(true);
  // CHOLMOD sums in the same order for one to three columns.
  constexpr Index width = 3;
  const Index number_of_groups = (right_hand_sides.cols() + width - 1) / width;
  internal::for_each_index(
    static_cast<std::size_t>(number_of_groups), [&](const std::size_t group) {
      const Index first = static_cast<Index>(group) * width;
      const Index columns = (std::min)(width, solutions.cols() - first);
      auto result = solutions.middleCols(first, columns);
      internal::Cholmod_workspace workspace;
      if(!workspace.solve(m_factor.get(), right_hand_sides.middleCols(first, columns), result))
        solved = false;
    });
  return solved;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_USE_CHOLMOD
