// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LANE_FACTOR_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LANE_FACTOR_H

#include <CGAL/Canonical_pose_3/internal/Lanes.h>
#include <CGAL/Canonical_pose_3/internal/Sparse_factor.h>
#include <CGAL/Canonical_pose_3/internal/configuration.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/internal/Supernodal_factor.h>
#endif

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// A factorization of a symmetric positive definite matrix that is solved for right-hand sides in
// lanes. Row i of the matrix is row places()[i] of these.
// `FactorTraits`: a model of `SparseLinearAlgebraWithBlockFactorTraits_d`.
template <class FactorTraits>
class Lane_factor
{
public:
  // Analyses the pattern, for this object and for copies made before factoring; returns false if
  // memory runs out.
  bool analyze(const Eigen::SparseMatrix<double>& matrix)
  {
    m_size = matrix.rows();
    return true;
  }

  // Returns false if the matrix is not positive definite.
  bool factor(const Eigen::SparseMatrix<double>& matrix)
  {
    typename FactorTraits::NT denominator;
    m_traits = FactorTraits(); // copies may share a factor
    return m_traits.factor(typename FactorTraits::Matrix(matrix), denominator);
  }

  std::vector<int> places() const
  {
    std::vector<int> result(static_cast<std::size_t>(m_size));
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  // Solves in place; the first `width` lanes are in use. A solution that is not finite is returned
  // as it is.
  void solve(Lane_rows& rows, std::size_t width) const
  {
    typedef Eigen::Matrix<double, Eigen::Dynamic, NUMBER_OF_LANES, Eigen::RowMajor> Rows;
    const auto columns = static_cast<Eigen::Index>(width);
    Eigen::Map<Rows> all(rows.data(), m_size, NUMBER_OF_LANES);
    Eigen::MatrixXd solutions;
    m_traits.linear_solver(Eigen::MatrixXd(all.leftCols(columns)), solutions);
    all.leftCols(columns) = solutions;
  }

private:
  FactorTraits m_traits;
  Eigen::Index m_size = 0;
};

#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
template <>
class Lane_factor<Cholmod_factor_traits_d> : public Supernodal_factor
{};
#endif

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LANE_FACTOR_H
