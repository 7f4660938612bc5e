// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_LATTICE_BODY_DATA_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_LATTICE_BODY_DATA_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// See `Lattice_body_3`.
struct Lattice_body_data
{
  Point_matrix points;
  std::vector<std::array<int, 4>> cells;
  Eigen::VectorXd cell_weights;
  double volume = 0, spacing = 0;
  Eigen::SparseMatrix<double> embedding;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_LATTICE_BODY_DATA_H
