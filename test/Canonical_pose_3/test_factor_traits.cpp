// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors
#include "geodesic_fixtures.h"
#include "sparse_matrices.h"

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Sparse_factor.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#endif
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>

#include <gtest/gtest.h>

#include <limits>
#include <thread>

using namespace CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

template <class Traits>
class Factor_traits : public testing::Test
{
protected:
  static std::string refusal(const Sparse_matrix& matrix)
  {
    internal::Sparse_factor factor(internal::make_factor<Traits>);
    return message_of<std::runtime_error>([&] { factor.factor(matrix, "the test matrix"); });
  }
  static std::string not_definite()
  {
    return std::string("the test matrix is not positive definite (") + Traits::name() + ")";
  }
};

#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
using Models = testing::Types<Eigen_factor_traits_d, Cholmod_factor_traits_d>;
#else
using Models = testing::Types<Eigen_factor_traits_d>;
#endif
TYPED_TEST_SUITE(Factor_traits, Models);

// Residuals require no reference solver; the condition numbers of these matrices are below 1e4.
TYPED_TEST(Factor_traits, solves)
{
  for(const Sparse_matrix& matrix :
      {grid_matrix(30, 1, 0.01), grid_matrix(14, 14, 0.01), grid_matrix(1, 1, 2.)})
  {
    internal::Sparse_factor factor(internal::make_factor<TypeParam>);
    EXPECT_FALSE(factor.is_factored());
    factor.factor(matrix, "the test matrix");
    EXPECT_TRUE(factor.is_factored());
    const Eigen::MatrixXd b = waves(matrix.rows(), 5);
    EXPECT_LT((matrix * factor.solve(b) - b).cwiseAbs().maxCoeff(), 1e-11);
    const Sparse_matrix lower = matrix.triangularView<Eigen::Lower>();
    internal::Sparse_factor from_lower(internal::make_factor<TypeParam>);
    from_lower.factor(lower, "its lower triangle");
    EXPECT_EQ(from_lower.solve(b), factor.solve(b));
    EXPECT_EQ(factor.solve(Eigen::MatrixXd(b.rows(), 0)).cols(), 0);
  }
}

// The columns of a block are solved independently, from any number of threads.
TYPED_TEST(Factor_traits, columns_are_independent)
{
  for(const Sparse_matrix& matrix : {grid_matrix(40, 1, 0.01), grid_matrix(14, 14, 0.01)})
  {
    internal::Sparse_factor factor(internal::make_factor<TypeParam>);
    factor.factor(matrix, "the test matrix");
    const Eigen::MatrixXd b = waves(matrix.rows(), 19), block = factor.solve(b);
    Eigen::MatrixXd single(b.rows(), b.cols());
    std::vector<std::thread> threads;
    for(Eigen::Index first = 0; first < 3; ++first)
      threads.emplace_back([&, first] {
        for(Eigen::Index k = first; k < b.cols(); k += 3)
          single.col(k) = factor.solve(b.col(k));
      });
    for(std::thread& thread : threads)
      thread.join();
    EXPECT_EQ(single, block);
    EXPECT_EQ(factor.solve(b.middleCols(3, 4)), block.middleCols(3, 4));
  }
}

// The Laplacian without shift is singular: its last pivot is a rounding error. A shift of -1 makes
// it indefinite.
TYPED_TEST(Factor_traits, refuses_what_is_not_positive_definite)
{
  for(int m : {1, 14})
    for(double shift : {0., -1., std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()})
      EXPECT_EQ(this->refusal(grid_matrix(14, m, shift)), this->not_definite())
        << m << ' ' << shift;
  EXPECT_EQ(this->refusal(Sparse_matrix(4, 4)), this->not_definite());
  EXPECT_EQ(this->refusal(grid_matrix(14, 14, 1e-6)), "nothing");
}

// After a refusal, a new matrix of a different size can be factored.
TYPED_TEST(Factor_traits, is_used_again)
{
  internal::Sparse_factor factor(internal::make_factor<TypeParam>);
  factor.factor(grid_matrix(5, 1, 1.), "the first matrix");
  EXPECT_THROW(factor.factor(grid_matrix(6, 1, -9.), "the second matrix"), std::runtime_error);
  EXPECT_FALSE(factor.is_factored());
  EXPECT_THROW(factor.solve(waves(36, 1)), CGAL::Precondition_exception);
  const Sparse_matrix third = grid_matrix(7, 1, 3.);
  factor.factor(third, "the third matrix");
  EXPECT_LT((third * factor.solve(waves(49, 2)) - waves(49, 2)).norm(), 1e-12);
  EXPECT_THROW(factor.solve(waves(50, 1)), CGAL::Precondition_exception);
  Eigen::MatrixXd bad = waves(49, 2);
  bad(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<std::runtime_error>([&] { factor.solve(bad); }),
            std::string("a solution for the third matrix is not finite (") + factor.name() + ")");
}

// The interface of CGAL's own concept, on the same system.
TYPED_TEST(Factor_traits, vectors_of_cgal)
{
  const Sparse_matrix matrix = grid_matrix(9, 1, 0.5);
  const typename TypeParam::Matrix a(matrix);
  typename TypeParam::Vector b(81), x(81), y(81);
  for(std::size_t i = 0; i < 81; ++i)
    b.set(i, double(i % 7));
  typename TypeParam::NT denominator = 0;
  TypeParam traits;
  ASSERT_TRUE(traits.factor(a, denominator));
  EXPECT_EQ(denominator, 1.);
  EXPECT_TRUE(traits.linear_solver(b, x));
  EXPECT_LT((matrix * x.eigen_object() - b.eigen_object()).norm(), 1e-12);
  EXPECT_TRUE(TypeParam().linear_solver(a, b, y, denominator));
  EXPECT_EQ(x.eigen_object(), y.eigen_object());
}

#if defined(CGAL_CANONICAL_POSE_3_USE_CHOLMOD) && defined(CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENMP)
// OpenMP is off in the scope of the object only. For a user who has turned it off, it remains so.
TEST(Cholmod_factor_traits, turns_openmp_off)
{
  using namespace internal;
  if(canonical_pose_3_get_openmp_levels == nullptr)
    GTEST_SKIP() << "CHOLMOD of this machine does not use OpenMP";
  const int before = canonical_pose_3_get_openmp_levels();
  for(int levels : {3, 0})
  {
    canonical_pose_3_set_openmp_levels(levels);
    {
      const Openmp_off off;
      EXPECT_EQ(canonical_pose_3_get_openmp_levels(), 0);
    }
    EXPECT_EQ(canonical_pose_3_get_openmp_levels(), levels);
    Sparse_factor factor(make_factor<Cholmod_factor_traits_d>);
    factor.factor(grid_matrix(14, 14, 0.01), "the test matrix");
    EXPECT_EQ(canonical_pose_3_get_openmp_levels(), levels);
  }
  canonical_pose_3_set_openmp_levels(before);
}
#endif

#if defined(CGAL_CANONICAL_POSE_3_USE_CHOLMOD) && defined(CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENBLAS)
// OpenBLAS splits sums depending on the number of its threads. For any user setting, results do not
// change, and neither does the setting.
TEST(Cholmod_factor_traits, holds_openblas_to_one_thread)
{
  using namespace internal;
  if(openblas_set_num_threads == nullptr || openblas_get_num_threads == nullptr)
    GTEST_SKIP() << "the BLAS of this machine is not OpenBLAS";
  const int before = openblas_get_num_threads();
  const Sparse_matrix matrix = grid_matrix(20, 20, 0.01);
  std::vector<Eigen::MatrixXd> results;
  for(int threads : {1, 2})
  {
    openblas_set_num_threads(threads);
    Sparse_factor factor(make_factor<Cholmod_factor_traits_d>);
    factor.factor(matrix, "the test matrix");
    results.push_back(factor.solve(waves(matrix.rows(), 3)));
    EXPECT_EQ(openblas_get_num_threads(), threads);
  }
  EXPECT_EQ(results[0], results[1]);
  openblas_set_num_threads(before);
}
#endif
