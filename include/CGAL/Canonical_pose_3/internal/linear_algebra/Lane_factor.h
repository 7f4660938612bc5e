// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANE_FACTOR_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANE_FACTOR_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>

#include <CGAL/Default.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

class Cholmod_factor_traits_d;

namespace internal {

// A factorization of a symmetric positive definite matrix that is solved for right-hand sides in
// lanes. Row i of the matrix is row places()[i] of the right-hand sides.
// `FactorTraits`: a model of `SparseLinearAlgebraWithBlockFactorTraits_d`.
template <class FactorTraits>
class Lane_factor
{
public:
  // Analyzes the pattern, for this object and for copies created before factoring.
  void analyze(const Eigen::SparseMatrix<double>& matrix) { m_size = matrix.rows(); }

  // Returns false if the matrix is not positive definite.
  bool factor(const Eigen::SparseMatrix<double>& matrix)
  {
    typename FactorTraits::NT denominator;
    m_traits = std::make_shared<FactorTraits>(); // copies of this object may differ
    return m_traits->factor(typename FactorTraits::Matrix(matrix), denominator);
  }

  std::vector<int> places() const
  {
    std::vector<int> result(static_cast<std::size_t>(m_size));
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  // Solves in place; the first `width` lanes are in use. A solution that is not finite is
  // returned as is.
  void solve(Lane_rows& rows, std::size_t width) const
  {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, NUMBER_OF_LANES, Eigen::RowMajor>;
    const auto columns = static_cast<Eigen::Index>(width);
    Eigen::Map<Rows> all(rows.data(), m_size, NUMBER_OF_LANES);
    Eigen::MatrixXd solutions;
    m_traits->linear_solver(Eigen::MatrixXd(all.leftCols(columns)), solutions);
    all.leftCols(columns) = solutions;
  }

  static const char* name() { return FactorTraits::name(); }

private:
  std::shared_ptr<FactorTraits> m_traits; // which need not be copyable
  Eigen::Index m_size = 0;
};

// A factor for lanes, chosen at run time.
class Lane_factor_base
{
public:
  virtual ~Lane_factor_base() = default;
  // A factor with the same analysis.
  virtual std::unique_ptr<Lane_factor_base> copy() const = 0;
  virtual void analyze(const Eigen::SparseMatrix<double>& matrix) = 0;
  virtual bool factor(const Eigen::SparseMatrix<double>& matrix) = 0;
  virtual std::vector<int> places() const = 0;
  virtual void solve(Lane_rows& rows, std::size_t width) const = 0;
  virtual const char* name() const = 0;
};

// Creates a factor without a matrix.
using Lane_factor_maker = std::unique_ptr<Lane_factor_base> (*)();

// `Factor`: `Lane_factor`, or a class with the same functions.
template <class Factor>
class Lane_factor_model final : public Lane_factor_base
{
public:
  std::unique_ptr<Lane_factor_base> copy() const override
  {
    return std::make_unique<Lane_factor_model>(*this);
  }
  void analyze(const Eigen::SparseMatrix<double>& matrix) override { m_factor.analyze(matrix); }
  bool factor(const Eigen::SparseMatrix<double>& matrix) override
  {
    return m_factor.factor(matrix);
  }
  std::vector<int> places() const override { return m_factor.places(); }
  void solve(Lane_rows& rows, const std::size_t width) const override
  {
    m_factor.solve(rows, width);
  }
  const char* name() const override { return Factor::name(); }

private:
  Factor m_factor;
};

// The factor of `Default_factor_traits_d`; with CHOLMOD, a `Supernodal_factor`.
std::unique_ptr<Lane_factor_base> make_default_lane_factor();

template <class FactorTraits>
std::unique_ptr<Lane_factor_base> make_lane_factor()
{
  if constexpr(std::is_same<FactorTraits, Default>::value
               || std::is_same<FactorTraits, Cholmod_factor_traits_d>::value)
    return make_default_lane_factor();
  else
    return std::make_unique<Lane_factor_model<Lane_factor<FactorTraits>>>();
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANE_FACTOR_H
