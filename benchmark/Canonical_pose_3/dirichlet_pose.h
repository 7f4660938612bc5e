// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_DIRICHLET_POSE_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_DIRICHLET_POSE_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include "Sparse_system.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace Canonical_pose_benchmark {

/// Returns sum_t w_t G_t^t G_t; row k of G_t is the gradient of the barycentric coordinate of vertex k.
inline Eigen::SparseMatrix<double>
dirichlet_matrix(const CGAL::Canonical_pose_3::Point_matrix& points,
                 const std::vector<std::array<int, 4>>& cells, const Eigen::VectorXd& cell_weights)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t t = 0; t < cells.size(); ++t)
  {
    Eigen::Matrix3d edges;
    for(std::size_t k = 0; k < 3; ++k)
      edges.col(static_cast<Eigen::Index>(k)) = points.row(cells[t][k]) - points.row(cells[t][3]);
    Eigen::Matrix<double, 4, 3> gradients;
    gradients.topRows<3>() = edges.inverse();
    gradients.row(3) = -gradients.topRows<3>().colwise().sum();
    const Eigen::Matrix4d block
      = cell_weights[static_cast<Eigen::Index>(t)] * gradients * gradients.transpose();
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        entries.emplace_back(cells[t][static_cast<std::size_t>(i)],
                             cells[t][static_cast<std::size_t>(j)], block(i, j));
  }
  Eigen::SparseMatrix<double> result(points.rows(), points.rows());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

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
  const CP::Point_matrix rest = body.points() / length_scale;
  const Eigen::SparseMatrix<double> laplacian
    = detail_length * detail_length * dirichlet_matrix(rest, body.cells(), body.cell_weights());
  const Eigen::SparseMatrix<double> weighted = shares.asDiagonal() * body.embedding();
  const Sparse_system system(
    laplacian + Eigen::SparseMatrix<double>(body.embedding().transpose() * weighted));
  // the gradients of the rest pose are identities
  const Eigen::MatrixXd right_hand_side
    = weighted.transpose() * (target / length_scale) + laplacian * rest;
  return length_scale * (body.embedding() * system.solve(right_hand_side));
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_DIRICHLET_POSE_H
