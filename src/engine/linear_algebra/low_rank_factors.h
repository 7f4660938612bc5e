// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_LOW_RANK_FACTORS_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_LOW_RANK_FACTORS_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Computes V and d such that V diag(d) V^t = `matrix`, which is symmetric; V has orthonormal
// columns, and d has no zeros. Rows that are not connected by an entry are processed separately, so
// that small entries keep their digits in the presence of large ones elsewhere. Returns false,
// without a result, if more than `most_rows` rows are nonzero.
inline bool low_rank_factors(const Eigen::SparseMatrix<double>& matrix, const std::size_t most_rows,
                             Eigen::SparseMatrix<double>& v, Eigen::VectorXd& d)
{
  constexpr double relative_zero = 1e-14; // of an eigenvalue
  Disjoint_sets sets(static_cast<std::size_t>(matrix.cols()));
  std::vector<std::size_t> rows;
  for(Eigen::Index j = 0; j < matrix.outerSize(); ++j)
  {
    bool is_zero = true;
    for(Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
      if(it.value() != 0)
      {
        is_zero = false;
        sets.unite(static_cast<std::size_t>(it.row()), static_cast<std::size_t>(j));
      }
    if(!is_zero)
      rows.push_back(static_cast<std::size_t>(j));
    if(rows.size() > most_rows)
      return false;
  }
  std::map<std::size_t, std::vector<int>> groups;
  for(const std::size_t row : rows)
    groups[sets.representative(row)].push_back(static_cast<int>(row));

  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> values;
  for(const auto& [representative, group] : groups)
  {
    const Eigen::Index k = static_cast<Eigen::Index>(group.size());
    Eigen::MatrixXd block(k, k);
    for(Eigen::Index i = 0; i < k; ++i)
      for(Eigen::Index j = 0; j < k; ++j)
        block(i, j) = matrix.coeff(group[i], group[j]);
    const std::optional<Eigenpairs> spectrum = all_eigenpairs(block);
    if(!spectrum)
      return false;
    const double largest = spectrum->values.cwiseAbs().maxCoeff();
    for(Eigen::Index j = 0; j < k; ++j)
      if(std::abs(spectrum->values[j]) > relative_zero * largest)
      {
        for(Eigen::Index i = 0; i < k; ++i)
          entries.emplace_back(group[i], static_cast<int>(values.size()), spectrum->vectors(i, j));
        values.push_back(spectrum->values[j]);
      }
  }
  const Eigen::Index rank = static_cast<Eigen::Index>(values.size());
  d = Eigen::Map<const Eigen::VectorXd>(values.data(), rank);
  v.resize(matrix.rows(), rank);
  v.setFromTriplets(entries.begin(), entries.end());
  return true;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_LOW_RANK_FACTORS_H
