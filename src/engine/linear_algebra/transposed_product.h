// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_TRANSPOSED_PRODUCT_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_TRANSPOSED_PRODUCT_H

#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// y = A^t x, in parallel: each row of y is computed from a column of A.
inline void transposed_product(const Eigen::SparseMatrix<double>& a,
                               const Eigen::Ref<const Eigen::MatrixXd>& x, Point_matrix& y)
{
  y.resize(a.cols(), 3);
  for_each_block(static_cast<std::size_t>(a.cols()), [&](std::size_t, const std::size_t begin,
                                                         const std::size_t end) {
    for(auto j = static_cast<Eigen::Index>(begin); j < static_cast<Eigen::Index>(end); ++j)
    {
      double sum[3] = {0, 0, 0};
      for(Eigen::SparseMatrix<double>::InnerIterator it(a, j); it; ++it)
        for(int c = 0; c < 3; ++c)
          sum[c] += it.value() * x(it.row(), c);
      for(int c = 0; c < 3; ++c)
        y(j, c) = sum[c];
    }
  });
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_TRANSPOSED_PRODUCT_H
