// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/linear_algebra/Updated_factor.h"
#include "engine/linear_algebra/low_rank_factors.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace test_low_rank_update {

using CGAL::Canonical_pose_3::internal::Updated_factor;
using Long_matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// A weakly constrained chain: entries of very different magnitude, as in a registration.
Eigen::SparseMatrix<double> chain(const int n)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, i, 1e-4 + (i > 0) + (i + 1 < n));
    if(i > 0)
    {
      entries.emplace_back(i, i - 1, -1.);
      entries.emplace_back(i - 1, i, -1.);
    }
  }
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Three points of the chain; the last two are the same.
Eigen::SparseMatrix<double> points_of_chain(const int n)
{
  Eigen::SparseMatrix<double> u(n, 3);
  u.insert(3, 0) = 0.25;
  u.insert(4, 0) = 0.75;
  u.insert(40, 1) = 1;
  u.insert(40, 2) = 1;
  return u;
}

bool update(Updated_factor& factor, const Eigen::SparseMatrix<double>& u, const Eigen::Matrix3d& d)
{
  Eigen::SparseMatrix<double> v;
  Eigen::VectorXd diagonal;
  return CGAL::Canonical_pose_3::internal::low_rank_factors(d.sparseView(), 3, v, diagonal)
         && factor.update(u * v, diagonal);
}

// Different D: stiff, singular, indefinite, and one that removes entries of A0: the residual is due
// to rounding only, and the solution is that of a dense factorization of the sum with more digits
// (double precision could not even represent sums of 1e6 and 1e-4).
TEST(Low_rank_update, solves_as_a_new_factorization)
{
  const int n = 60;
  const Eigen::SparseMatrix<double> u = points_of_chain(n);
  Eigen::Matrix3d spring, pull, both, removal;
  spring << 1, -1, 0, -1, 1, 0, 0, 0, 0;
  pull << 0, 0, 0, 0, 2, 0, 0, 0, 3;
  both << 1e6, 0, 0, 0, 5, 0, 0, 0, -0.5;
  removal << -1e-3, 0, 0, 0, -1e-5, 0, 0, 0, 0;
  Eigen::MatrixXd b(n, 3);
  for(Eigen::Index i = 0; i < b.size(); ++i)
    b.data()[i] = std::sin(double(i));
  Updated_factor factor;
  factor.factor(chain(n), "chain");
  for(const Eigen::Matrix3d& d : {spring, Eigen::Matrix3d(1e6 * spring), pull, both, removal})
  {
    ASSERT_TRUE(update(factor, u, d)) << d;
    Eigen::MatrixXd x;
    factor.solve(b, x);
    const Long_matrix long_u = Eigen::MatrixXd(u).cast<long double>();
    const Long_matrix a = Eigen::MatrixXd(chain(n)).cast<long double>()
                          + long_u * d.cast<long double>() * long_u.transpose();
    const Long_matrix residual = a * x.cast<long double>() - b.cast<long double>();
    EXPECT_LT(residual.norm(), 1e-10 * (a.norm() * x.norm() + b.norm()));
    const Long_matrix exact = a.partialPivLu().solve(b.cast<long double>());
    EXPECT_LT((x - exact.cast<double>()).norm(), 1e-9 * x.norm()) << d;
  }
  factor.forget_update();
  Eigen::MatrixXd x;
  factor.solve(b, x);
  EXPECT_LT((chain(n) * x - b).norm(), 1e-9);
}

// Refused: a sum that is not positive definite; and an update that removes nearly all of A0, since
// the rest would have lost its digits.
TEST(Low_rank_update, refuses_what_it_cannot_solve)
{
  const int n = 60;
  const Eigen::SparseMatrix<double> u = points_of_chain(n);
  Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
  d(1, 1) = -10;
  Updated_factor factor;
  factor.factor(chain(n), "chain");
  EXPECT_FALSE(update(factor, u, d));
  d(1, 1) = 1e9;
  const Eigen::MatrixXd stiff = Eigen::MatrixXd(chain(n)) + u * d * u.transpose();
  factor.factor(stiff.sparseView(), "chain with a stiff handle");
  d(1, 1) = -1e9;
  EXPECT_FALSE(update(factor, u, d));
}

// The factors reproduce the matrix, including all digits of weak entries next to stiff ones; a rank
// below the number of rows is detected.
TEST(Low_rank_update, factors_of_a_matrix)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_spring = [&](const int p, const int q, const double k) {
    entries.insert(entries.end(), {{p, p, k}, {q, q, k}, {p, q, -k}, {q, p, -k}});
  };
  add_spring(2, 70, 1e9);
  add_spring(3, 71, -1e-9);
  add_spring(4, 5, 0.5);
  add_spring(5, 99, 0.25);
  entries.emplace_back(50, 50, 0.); // stored zero
  Eigen::SparseMatrix<double> matrix(100, 100), v;
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd d;
  using CGAL::Canonical_pose_3::internal::low_rank_factors;
  ASSERT_TRUE(low_rank_factors(matrix, 7, v, d));
  EXPECT_EQ(d.size(), 4);
  const Eigen::MatrixXd product = v * d.asDiagonal() * Eigen::MatrixXd(v).transpose();
  for(Eigen::Index i = 0; i < 100; ++i)
    for(Eigen::Index j = 0; j < 100; ++j)
      EXPECT_NEAR(product(i, j), matrix.coeff(i, j), 1e-14 * std::abs(matrix.coeff(i, i)));
  EXPECT_FALSE(low_rank_factors(matrix, 6, v, d));
  ASSERT_TRUE(low_rank_factors(Eigen::SparseMatrix<double>(100, 100), 0, v, d));
  EXPECT_EQ(v.cols(), 0);
}

} // namespace test_low_rank_update
