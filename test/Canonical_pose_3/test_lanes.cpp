// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"
#include "sparse_matrices.h"
#include "engine/heat/Gradient_field.h"
#include "engine/linear_algebra/Column_substitution.h"
#include "engine/linear_algebra/Supernodal_routines.h"

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#endif
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace test_lanes {

using namespace Canonical_pose_test;
using namespace CGAL::Canonical_pose_3;
using namespace CGAL::Canonical_pose_3::internal;

template <class Traits>
class Lane_factors : public testing::Test
{
protected:
  // Solves for the columns of `b` in lanes; undoes the elimination order.
  static Eigen::MatrixXd solve(const Lane_factor_base& factor, const Eigen::MatrixXd& b)
  {
    const std::vector<int> places = factor.places();
    Lane_rows rows(NUMBER_OF_LANES * places.size(), 0.);
    const auto entry = [&](Eigen::Index i, Eigen::Index k) -> double& {
      return rows[NUMBER_OF_LANES * std::size_t(places[std::size_t(i)]) + std::size_t(k)];
    };
    for(Eigen::Index k = 0; k < b.cols(); ++k)
      for(Eigen::Index i = 0; i < b.rows(); ++i)
        entry(i, k) = b(i, k);
    factor.solve(rows, std::size_t(b.cols()));
    Eigen::MatrixXd x(b.rows(), b.cols());
    for(Eigen::Index k = 0; k < b.cols(); ++k)
      for(Eigen::Index i = 0; i < b.rows(); ++i)
        x(i, k) = entry(i, k);
    return x;
  }
};

#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
using Models = testing::Types<Eigen_factor_traits_d, Cholmod_factor_traits_d>;
#else
using Models = testing::Types<Eigen_factor_traits_d>;
#endif
TYPED_TEST_SUITE(Lane_factors, Models);

// Residuals require no reference solver; the condition numbers of these matrices are below 1e4. A
// lane has the same bytes regardless of its position and of the other lanes.
TYPED_TEST(Lane_factors, solve_lane_by_lane)
{
  for(const Sparse_matrix& matrix :
      {grid_matrix(40, 1, 0.01), grid_matrix(14, 14, 0.01), grid_matrix(1, 1, 2.)})
  {
    const auto factor = make_lane_factor<TypeParam>();
    factor->analyze(matrix);
    ASSERT_TRUE(factor->factor(matrix));
    const Eigen::MatrixXd b = waves(matrix.rows(), 8), x = this->solve(*factor, b);
    EXPECT_LT((matrix * x - b).cwiseAbs().maxCoeff(), 1e-11);
    for(Eigen::Index k = 0; k < 8; ++k)
      EXPECT_EQ(this->solve(*factor, b.col(k)), x.col(k));
    Eigen::MatrixXd impulse = Eigen::MatrixXd::Zero(matrix.rows(), 3);
    impulse(matrix.rows() / 2, 1) = 1;
    EXPECT_LT((matrix * this->solve(*factor, impulse) - impulse).cwiseAbs().maxCoeff(), 1e-11);
  }
}

// A copy of an analysis factors another matrix with the same pattern, without affecting the first
// factor.
TYPED_TEST(Lane_factors, share_an_analysis)
{
  const Sparse_matrix first = grid_matrix(14, 14, 0.01), second = grid_matrix(14, 14, 3.);
  const Eigen::MatrixXd b = waves(first.rows(), 2);
  const auto factor = make_lane_factor<TypeParam>();
  factor->analyze(first);
  const auto other = factor->copy();
  ASSERT_TRUE(factor->factor(first));
  ASSERT_TRUE(other->factor(second));
  EXPECT_LT((first * this->solve(*factor, b) - b).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LT((second * this->solve(*other, b) - b).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_FALSE(other->factor(grid_matrix(14, 14, -1.)));
}

// Calls f(run) with each version of the routine that this processor supports.
template <class Routine, class Function>
void for_each_version(const Function& f)
{
  f([](auto... arguments) { Routine::template run<Vector_of_1>(arguments...); });
  f([](auto... arguments) { Routine::template run<Portable_vector>(arguments...); });
#ifdef CGAL_CANONICAL_POSE_3_HAS_X86_ROUTINES
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    f([](auto... arguments) { run_with_avx2<Routine>(arguments...); });
  if(__builtin_cpu_supports("avx512f"))
    f([](auto... arguments) { run_with_avx512<Routine>(arguments...); });
#endif
}

// Two blocks: columns 0 to 10 with the rows 0 to 10, 12, 19; columns 11 to 19.
struct Two_blocks
{
  std::vector<Factor_index> rows;
  std::array<Factor_index, 3> columns = {0, 11, 20}, first_rows = {0, 13, 22},
                              first_values = {0, 143, 224};
  std::vector<double> values = std::vector<double>(224), inverse_diagonal = std::vector<double>(20);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(20, 20);

  template <class Uniform>
  explicit Two_blocks(const Uniform& uniform)
  {
    for(Factor_index i = 0; i < 11; ++i)
      rows.push_back(i);
    rows.insert(rows.end(), {12, 19});
    for(Factor_index i = 11; i < 20; ++i)
      rows.push_back(i);
    for(double& v : values)
      v = uniform();
    for(std::size_t s = 0; s < 2; ++s)
      for(Factor_index j = columns[s], k = first_values[s]; j < columns[s + 1]; ++j)
        for(Factor_index r = first_rows[s]; r < first_rows[s + 1]; ++r, ++k)
          if(rows[std::size_t(r)] == j)
            inverse_diagonal[std::size_t(j)]
              = 1 / (dense(j, j) = values[std::size_t(k)] = 1 + 0.1 * double(j));
          else if(rows[std::size_t(r)] > j)
            dense(rows[std::size_t(r)], j) = values[std::size_t(k)];
  }

  Supernodal_matrix matrix() const
  {
    return {2,           columns.data(), first_rows.data(),      first_values.data(),
            rows.data(), values.data(),  inverse_diagonal.data()};
  }
};

// All versions compute the same sums, up to fused rounding: the reference is the dense matrix.
TEST(Lanes, every_version_substitutes)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  const Two_blocks blocks([&] { return uniform(generator); });
  const Supernodal_matrix matrix = blocks.matrix();
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, NUMBER_OF_LANES, Eigen::RowMajor>;
  Rows b(20, NUMBER_OF_LANES);
  for(Eigen::Index i = 0; i < b.size(); ++i)
    b.data()[i] = uniform(generator);
  b.topRows(11).setZero(); // nothing to do for the first block
  for(bool with_first : {false, true})
  {
    if(with_first)
      b(4, 2) = 1;
    for_each_version<Forward_substitution>([&](const auto& run) {
      Rows x = b;
      run(&matrix, x.data());
      EXPECT_LT((blocks.dense * x - b).cwiseAbs().maxCoeff(), 1e-14);
    });
    for_each_version<Backward_substitution>([&](const auto& run) {
      Rows x = b;
      run(&matrix, x.data());
      EXPECT_LT((blocks.dense.transpose() * x - b).cwiseAbs().maxCoeff(), 1e-14);
    });
  }
}

// The same for columns. If only the rows of the first block are in reach, what it subtracts from the
// others is collected.
TEST(Columns, every_version_substitutes)
{
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  const Two_blocks blocks([&] { return uniform(generator); });
  const Supernodal_matrix matrix = blocks.matrix();
  const Eigen::MatrixXd b
    = Eigen::MatrixXd::NullaryExpr(20, NUMBER_OF_COORDINATES, [&] { return uniform(generator); });
  std::vector<int> places(20);
  std::iota(places.begin() + 11, places.end(), 0);
  Eigen::MatrixXd x, sums, work(13, NUMBER_OF_COORDINATES);
  const auto rows = [&](std::size_t end) {
    x = b;
    sums = Eigen::MatrixXd::Zero(9, NUMBER_OF_COORDINATES);
    return Column_substitution_rows{
      {x.data(), 20}, end, {sums.data(), 9}, places.data(), {work.data(), 13}};
  };
  const std::size_t first = 0, last = 1;
  for_each_version<Forward_column_substitution>([&](const auto& run) {
    Column_substitution_rows all = rows(20), reached = all;
    run(&matrix, first, last, static_cast<const Column_substitution_rows*>(&all));
    EXPECT_LT((blocks.dense * x - b).cwiseAbs().maxCoeff(), 1e-14);
    const Eigen::MatrixXd expected = x;
    reached = rows(11);
    run(&matrix, first, first, static_cast<const Column_substitution_rows*>(&reached));
    EXPECT_EQ(x.bottomRows(9), b.bottomRows(9));
    x.bottomRows(9) += sums;
    run(&matrix, last, last, static_cast<const Column_substitution_rows*>(&all));
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-15);
  });
  for_each_version<Backward_column_substitution>([&](const auto& run) {
    const Column_substitution_rows all = rows(20);
    run(&matrix, first, last, &all);
    EXPECT_LT((blocks.dense.transpose() * x - b).cwiseAbs().maxCoeff(), 1e-14);
  });
}

// One face, u linear on it: the field is minus the unit gradient, and its integral against the
// gradients of the hat functions is known from the corners. NaN functions remain NaN; constants
// yield 0.
TEST(Lanes, every_version_normalizes_gradients)
{
  const Face_in_plane face = {{{2, 0, 1}}, 3., 1., 2.};
  const Eigen::Vector2d slope(0.6, -0.8);
  const double area = 3.;
  // gradients of the hats of the three corners (0,0), (3,0), (1,2)
  const std::array<Eigen::Vector2d, 3> hats = {
    Eigen::Vector2d(-1 / 3., -1 / 3.), Eigen::Vector2d(1 / 3., -1 / 6.), Eigen::Vector2d(0, 0.5)};
  const std::array<double, NUMBER_OF_LANES> scales
    = {1., 1e-290, 1e290, 3e-308, 0., std::numeric_limits<double>::quiet_NaN(), -5., 1e-160};
  Lane_rows u(3 * NUMBER_OF_LANES, 0.);
  for(std::size_t k = 0; k < NUMBER_OF_LANES; ++k)
  {
    u[NUMBER_OF_LANES * 0 + k] = scales[k] * 3 * slope[0];
    u[NUMBER_OF_LANES * 1 + k] = scales[k] * (slope[0] + 2 * slope[1]);
  }
  for_each_version<Unit_descent>([&](const auto& run) {
    Lane_rows result(3 * NUMBER_OF_LANES, 0.);
    run(&face, std::size_t(1), u.data(), result.data());
    for(std::size_t k = 0; k < NUMBER_OF_LANES; ++k)
      for(std::size_t corner = 0; corner < 3; ++corner)
      {
        const double value = result[NUMBER_OF_LANES * std::size_t(face.corners[corner]) + k];
        const double sign = scales[k] > 0 ? 1. : scales[k] < 0 ? -1. : 0.;
        if(scales[k] == scales[k])
          EXPECT_NEAR(value, -sign * area * hats[corner].dot(slope), 1e-14) << k;
        else
          EXPECT_NE(value, value);
      }
  });
}

} // namespace test_lanes
