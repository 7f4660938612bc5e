// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_LATTICE_BODY_DATA_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_LATTICE_BODY_DATA_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
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
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_LATTICE_BODY_DATA_H
