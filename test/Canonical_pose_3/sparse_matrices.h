// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_SPARSE_MATRICES_H
#define CGAL_CANONICAL_POSE_3_TEST_SPARSE_MATRICES_H

// Procedural linear systems.

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <utility>
#include <vector>

namespace Canonical_pose_test {

using Sparse_matrix = Eigen::SparseMatrix<double>;

/// Laplacian of the graph of an n x n x m grid, plus `shift` times the identity: eigenvalues
/// `shift` and above. CHOLMOD factors surfaces (m = 1) column by column, and larger volumes in
/// dense blocks.
inline Sparse_matrix grid_matrix(int n, int m, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int i, int j) {
    for(const auto& e : {std::make_pair(i, j), std::make_pair(j, i)})
    {
      entries.emplace_back(e.first, e.first, 1.);
      entries.emplace_back(e.first, e.second, -1.);
    }
  };
  for(int i = 0; i < n * n * m; ++i)
  {
    entries.emplace_back(i, i, shift);
    if(i % n + 1 < n)
      join(i, i + 1);
    if(i / n % n + 1 < n)
      join(i, i + n);
    if(i / (n * n) + 1 < m)
      join(i, i + n * n);
  }
  Sparse_matrix matrix(n * n * m, n * n * m);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Right-hand sides without randomness.
inline Eigen::MatrixXd waves(Eigen::Index rows, Eigen::Index columns)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [](Eigen::Index i, Eigen::Index k) {
    return std::sin(double(i * (k + 1))) + 0.1 * double(k);
  });
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_SPARSE_MATRICES_H
