// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_BIHARMONIC_EMBEDDING_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_BIHARMONIC_EMBEDDING_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Maps vertex i to the vector (phi_k(i) / lambda_k)_k, component by component.
struct Biharmonic_embedding
{
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> vectors;
  std::vector<int> component; // of each vertex
  int exponent = 0;           // distances are multiplied by 2 to this power

  // From vertex `source` to all.
  Eigen::VectorXd distances(std::size_t source) const;
};

Biharmonic_embedding biharmonic_embedding(const Face_corners& corners, const Point_matrix& points,
                                          std::size_t number_of_eigenfunctions,
                                          Factor_maker factor_maker);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_BIHARMONIC_EMBEDDING_H
