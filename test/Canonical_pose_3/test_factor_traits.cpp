// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"
#include "sparse_matrices.h"
#include "engine/linear_algebra/Sparse_factor.h"

#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include "engine/linear_algebra/Cholmod_factor.h"
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#endif
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>

#include <gtest/gtest.h>

#ifdef __unix__
#include <dlfcn.h>
#endif

#include <cstdlib>
#include <limits>
#include <new>
#include <thread>

namespace test_factor_traits {

using namespace CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

// Allocations of more bytes fail.
std::size_t most_bytes = std::size_t(-1);

class Little_memory
{
public:
  Little_memory() { most_bytes = 1000000; }
  ~Little_memory() { most_bytes = std::size_t(-1); }
};

} // namespace test_factor_traits

// Eigen's sparse matrices are in such arrays.
void* operator new[](const std::size_t size)
{
  if(size > test_factor_traits::most_bytes)
    throw std::bad_alloc();
  return ::operator new(size);
}
void operator delete[](void* const pointer) noexcept { ::operator delete(pointer); }
void operator delete[](void* const pointer, std::size_t) noexcept { ::operator delete(pointer); }

namespace test_factor_traits {

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

#if defined(CGAL_CANONICAL_POSE_3_USE_CHOLMOD) && defined(CGAL_CANONICAL_POSE_3_HAS_WEAK_REFERENCES)
// OpenMP is off in the scope of the object only. For a user who has turned it off, it remains so.
TEST(Cholmod_factor_traits, turns_openmp_off)
{
  using namespace internal;
  if(get_openmp_levels == nullptr)
    GTEST_SKIP() << "CHOLMOD of this machine does not use OpenMP";
  const int before = get_openmp_levels();
  for(int levels : {3, 0})
  {
    set_openmp_levels(levels);
    {
      const Openmp_off off;
      EXPECT_EQ(get_openmp_levels(), 0);
    }
    EXPECT_EQ(get_openmp_levels(), levels);
    Sparse_factor factor(make_factor<Cholmod_factor_traits_d>);
    factor.factor(grid_matrix(14, 14, 0.01), "the test matrix");
    EXPECT_EQ(get_openmp_levels(), levels);
  }
  set_openmp_levels(before);
}
#endif

#if defined(CGAL_CANONICAL_POSE_3_USE_CHOLMOD) && defined(CGAL_CANONICAL_POSE_3_HAS_WEAK_REFERENCES)
// OpenBLAS splits sums depending on the number of its threads. For any user setting, results do not
// change, and neither does the setting.
TEST(Cholmod_factor_traits, holds_openblas_to_one_thread)
{
  using namespace internal;
  if(set_openblas_threads == nullptr || get_openblas_threads == nullptr)
    GTEST_SKIP() << "the BLAS of this machine is not OpenBLAS";
  const int before = get_openblas_threads();
  const Sparse_matrix matrix = grid_matrix(20, 20, 0.01);
  std::vector<Eigen::MatrixXd> results;
  for(int threads : {1, 2})
  {
    set_openblas_threads(threads);
    Sparse_factor factor(make_factor<Cholmod_factor_traits_d>);
    factor.factor(matrix, "the test matrix");
    results.push_back(factor.solve(waves(matrix.rows(), 3)));
    EXPECT_EQ(get_openblas_threads(), threads);
  }
  EXPECT_EQ(results[0], results[1]);
  set_openblas_threads(before);
}
#endif

// A matrix cannot be factored for three reasons; a message does not blame the matrix for the other
// two. Each array of these two matrices has less than a million bytes, but not those of the factors.
TEST(Eigen_factor_traits, reports_lack_of_memory)
{
  const Sparse_matrix matrix = grid_matrix(14, 14, 0.01);
  internal::Sparse_factor factor(internal::make_factor<Eigen_factor_traits_d>);
  {
    const Little_memory little;
    EXPECT_EQ(message_of<std::runtime_error>([&] { factor.factor(matrix, "the test matrix"); }),
              "there is not enough memory for the factor of a matrix with 2744 rows (Eigen "
              "SimplicialLDLT)");
  }
  EXPECT_FALSE(factor.is_factored());
  factor.factor(matrix, "the test matrix");
  EXPECT_TRUE(factor.is_factored());
}

// Two columns with as many entries as an index can count, the sum overflows to -2.
TEST(Eigen_factor_traits, reports_factors_that_are_too_large)
{
  constexpr int most = (std::numeric_limits<int>::max)();
  const std::vector<int> begin = {0, most, -2};
  EXPECT_NO_THROW(internal::Checked_ldlt::check(begin.data(), 1));
  EXPECT_EQ(message_of<std::runtime_error>([&] { internal::Checked_ldlt::check(begin.data(), 2); }),
            "the factor of a matrix with 2 rows is too large: it has more than 2147483647 entries "
            "(Eigen SimplicialLDLT)");
}

#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
// In its given order, the factor of this matrix has no zero: 18 GB.
TEST(Cholmod_factor_traits, analyzes_factors_of_any_size)
{
  constexpr int n = 47000;
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, 0, 1.);
    entries.emplace_back(i, i, n);
  }
  internal::Cholmod_matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  cholmod_sparse view = internal::lower_triangle(matrix);
  internal::Cholmod_common common;
  common.get()->nmethods = 1;
  common.get()->method[0].ordering = CHOLMOD_NATURAL;
  const auto factor = internal::own_cholmod_factor(cholmod_l_analyze(&view, common.get()));
  ASSERT_NE(factor, nullptr);
  EXPECT_EQ(factor->xsize, std::size_t(n) * n);
}

TEST(Cholmod_factor_traits, failures)
{
  internal::Cholmod_common common;
  for(const int status : {CHOLMOD_OK, CHOLMOD_NOT_POSDEF})
  {
    common.get()->status = status;
    EXPECT_NO_THROW(common.check(7));
  }
  for(const int status : {CHOLMOD_OUT_OF_MEMORY, CHOLMOD_TOO_LARGE})
  {
    common.get()->status = status;
    EXPECT_EQ(message_of<std::runtime_error>([&] { common.check(7); }),
              "there is not enough memory for the factor of a matrix with 7 rows (CHOLMOD)");
  }
}

#if defined(__unix__) && SUITESPARSE_VERSION < SUITESPARSE_VER_CODE(6, 0)
// Column by column (a surface), and in dense blocks (a volume).
TEST(Cholmod_factor_traits, reports_lack_of_memory)
{
  auto* const functions
    = static_cast<SuiteSparse_config_struct*>(dlsym(RTLD_DEFAULT, "SuiteSparse_config"));
  if(functions == nullptr)
    GTEST_SKIP() << "SuiteSparse is not a shared library";
  const SuiteSparse_config_struct original = *functions;
  for(const Sparse_matrix& matrix : {grid_matrix(100, 1, 0.01), grid_matrix(14, 14, 0.01)})
  {
    const std::string expected = "there is not enough memory for the factor of a matrix with "
                                 + std::to_string(matrix.rows()) + " rows (CHOLMOD)";
    internal::Sparse_factor factor(internal::make_factor<Cholmod_factor_traits_d>);
    functions->malloc_func
      = [](const std::size_t size) { return size > most_bytes ? nullptr : std::malloc(size); };
    functions->realloc_func = [](void* const pointer, const std::size_t size) {
      return size > most_bytes ? nullptr : std::realloc(pointer, size);
    };
    {
      const Little_memory little;
      EXPECT_EQ(message_of<std::runtime_error>([&] { factor.factor(matrix, "the test matrix"); }),
                expected);
    }
    *functions = original;
    factor.factor(matrix, "the test matrix");
    EXPECT_TRUE(factor.is_factored());
  }
}
#endif
#endif

} // namespace test_factor_traits
