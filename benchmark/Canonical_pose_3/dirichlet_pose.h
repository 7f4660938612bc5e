// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_DIRICHLET_POSE_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_DIRICHLET_POSE_H

#include <CGAL/Canonical_pose_3/internal/energy/Arap_energy.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Sparse_factor.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>

#include <Eigen/SparseCore>

namespace Canonical_pose_benchmark {

/// The surface of a body under the Dirichlet energy, Equation 14 of the paper: identities in the place
/// of rotations, sum_i m_i |(Bv)_i - target_i|^2 / L^2 + l^2 sum_t w_t |F_t - I|^2. That is quadratic:
/// one system.
/// `ElasticBody`: a model of the concept; `shares`: m, with sum 1.
template <class ElasticBody>
CGAL::Canonical_pose_3::Point_matrix
dirichlet_pose(const ElasticBody& body, const Eigen::VectorXd& shares,
               const CGAL::Canonical_pose_3::Point_matrix& target, const double length_scale,
               const double detail_length)
{
  namespace CP = CGAL::Canonical_pose_3;
  const double alpha = detail_length * detail_length;
  const CP::Point_matrix rest = body.points() / length_scale;
  const Eigen::SparseMatrix<double> laplacian
    = CP::internal::Arap_energy(rest, body.cells(), body.cell_weights(), Eigen::VectorXd())
        .matrix(alpha);
  const Eigen::SparseMatrix<double> weighted = shares.asDiagonal() * body.embedding();
  CP::internal::Sparse_factor factor;
  factor.factor(laplacian + Eigen::SparseMatrix<double>(body.embedding().transpose() * weighted),
                "the matrix of the Dirichlet energy");
  // the gradients of the rest pose are identities
  const Eigen::MatrixXd right_hand_side
    = weighted.transpose() * (target / length_scale) + laplacian * rest;
  return length_scale * (body.embedding() * factor.solve(right_hand_side));
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_DIRICHLET_POSE_H
