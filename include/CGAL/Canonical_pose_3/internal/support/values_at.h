// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_VALUES_AT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_VALUES_AT_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The values at some indices.
inline Eigen::VectorXd values_at(const Eigen::VectorXd& values,
                                 const std::vector<std::size_t>& indices)
{
  Eigen::VectorXd result(static_cast<Eigen::Index>(indices.size()));
  for(std::size_t i = 0; i < indices.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = values[static_cast<Eigen::Index>(indices[i])];
  return result;
}

template <class Matrix>
typename Matrix::PlainObject rows_at(const Eigen::MatrixBase<Matrix>& rows,
                                     const std::vector<std::size_t>& indices)
{
  typename Matrix::PlainObject result(static_cast<Eigen::Index>(indices.size()), rows.cols());
  for(std::size_t i = 0; i < indices.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = rows.row(static_cast<Eigen::Index>(indices[i]));
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_VALUES_AT_H
