// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/energy/closest_rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace test_closest_rotation {

namespace CPI = CGAL::Canonical_pose_3::internal;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// By a singular value decomposition in extended precision.
Matrix3d reference(const Matrix3d& m)
{
  using Matrix = Eigen::Matrix<long double, 3, 3>;
  const Eigen::JacobiSVD<Matrix> svd(m.cast<long double>(),
                                     Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix u = svd.matrixU();
  if((u * svd.matrixV().transpose()).determinant() < 0)
    u.col(2) *= -1;
  return (u * svd.matrixV().transpose()).cast<double>();
}

class Random_matrices
{
public:
  Matrix3d matrix()
  {
    return Matrix3d::NullaryExpr([&] { return m_normal(m_generator); });
  }
  Matrix3d with_singular_values(const Vector3d& s)
  {
    return reference(matrix()) * s.asDiagonal() * reference(matrix()).transpose();
  }

private:
  std::mt19937 m_generator{7};
  std::normal_distribution<double> m_normal;
};

// Eight matrices at once.
std::vector<Matrix3d> rotations_of_pack(const std::vector<Matrix3d>& matrices)
{
  CPI::Lane_matrix f, r;
  for(std::size_t lane = 0; lane < CPI::NUMBER_OF_LANES; ++lane)
    CPI::set_matrix_of_lane(f, lane, matrices[lane]);
  CPI::closest_rotations(f, r);
  std::vector<Matrix3d> result;
  for(std::size_t lane = 0; lane < CPI::NUMBER_OF_LANES; ++lane)
    result.push_back(CPI::matrix_of_lane(r, lane));
  return result;
}

bool is_rotation(const Matrix3d& r)
{
  return (r.transpose() * r - Matrix3d::Identity()).norm() < 1e-12 && r.determinant() > 0;
}

// If the closest rotation is clearly unique, that is, the sum of the two smaller singular values
// (with sign) is not small, the closed form is accurate to twelve digits: near rotations,
// stretched, reflected, flat, and in any unit.
TEST(Closest_rotation, is_that_of_the_singular_value_decomposition)
{
  Random_matrices random;
  for(int run = 0; run < 2000; ++run)
  {
    std::vector<Matrix3d> matrices = {
      reference(random.matrix()) + 0.1 * random.matrix(),
      random.with_singular_values(Vector3d(1, 1, 1)),
      random.with_singular_values(Vector3d(1, 1, -0.9)),
      random.with_singular_values(Vector3d(1, 0.7, -0.6)),
      random.with_singular_values(Vector3d(1, 0.3, 0)),
      random.with_singular_values(Vector3d(100, 5, 1e-6)),
      1e-30 * random.with_singular_values(Vector3d(3, 2, 1)),
      1e30 * random.with_singular_values(Vector3d(3, 2, -1)),
    };
    const std::vector<Matrix3d> rotations = rotations_of_pack(matrices);
    for(std::size_t lane = 0; lane < CPI::NUMBER_OF_LANES; ++lane)
    {
      const Matrix3d expected = reference(matrices[lane]);
      EXPECT_LT((rotations[lane] - expected).norm(), 1e-12) << run << ' ' << lane;
      EXPECT_LT((CPI::closest_rotation(matrices[lane]) - expected).norm(), 1e-12) << lane;
    }
  }
}

// If it is not unique, the result is a rotation, and no rotation is closer: trace(R^t F) is the sum
// of the singular values, the smallest one with the sign of the determinant.
TEST(Closest_rotation, is_a_closest_one_where_it_is_not_unique)
{
  Random_matrices random;
  const std::vector<Vector3d> values = {{0, 0, 0},
                                        {1, 0, 0},
                                        {1, 1e-9, 0},
                                        {1, 1, -1},
                                        {1, 0.5, -0.5},
                                        {1, 0.5, -0.499999},
                                        {1e-200, 1e-200, 1e-200},
                                        {1e200, 1e200, -1e200}};
  for(int run = 0; run < 200; ++run)
  {
    std::vector<Matrix3d> matrices;
    for(const Vector3d& s : values)
      matrices.push_back(random.with_singular_values(s));
    const std::vector<Matrix3d> rotations = rotations_of_pack(matrices);
    for(std::size_t lane = 0; lane < CPI::NUMBER_OF_LANES; ++lane)
      for(const Matrix3d& r : {rotations[lane], CPI::closest_rotation(matrices[lane])})
      {
        EXPECT_TRUE(is_rotation(r)) << lane;
        const double trace = (r.transpose() * matrices[lane]).trace();
        EXPECT_NEAR(trace, values[lane].sum(), 1e-12 * values[lane].cwiseAbs().sum()) << lane;
      }
  }
}

// At the double root of a matrix of rank one both the polynomial and its derivative are rounding
// errors, whose quotient is arbitrary; for about one in ten thousand matrices, it was mistaken for
// the last step.
TEST(Closest_rotation, of_matrices_of_rank_one)
{
  Random_matrices random;
  for(int run = 0; run < 20000; ++run)
  {
    const Matrix3d m = random.with_singular_values({1, 0, 0});
    const Matrix3d r = CPI::closest_rotation(m);
    ASSERT_TRUE(is_rotation(r)) << run;
    ASSERT_NEAR((r.transpose() * m).trace(), 1, 1e-12) << run;
  }
}

// Non-finite numbers neither cause endless loops nor affect other lanes.
TEST(Closest_rotation, of_what_is_not_finite_is_a_rotation)
{
  Random_matrices random;
  std::vector<Matrix3d> matrices;
  for(std::size_t lane = 0; lane < CPI::NUMBER_OF_LANES; ++lane)
    matrices.push_back(random.with_singular_values(Vector3d(3, 2, 1)));
  matrices[1](0, 2) = std::numeric_limits<double>::quiet_NaN();
  matrices[4](1, 1) = std::numeric_limits<double>::infinity();
  const std::vector<Matrix3d> rotations = rotations_of_pack(matrices);
  for(std::size_t lane = 0; lane < CPI::NUMBER_OF_LANES; ++lane)
  {
    EXPECT_TRUE(is_rotation(rotations[lane])) << lane;
    if(matrices[lane].allFinite())
    {
      EXPECT_LT((rotations[lane] - reference(matrices[lane])).norm(), 1e-12) << lane;
    }
  }
}

// A model of CGAL's concept can be used instead.
TEST(Closest_rotation, by_traits)
{
  using Traits = CGAL::Deformation_Eigen_closest_rotation_traits_3;
  Random_matrices random;
  for(int run = 0; run < 100; ++run)
  {
    const Matrix3d m = random.matrix();
    EXPECT_LT((CPI::rotation_by_traits<Traits>(m) - reference(m)).norm(), 1e-10);
  }
}

} // namespace test_closest_rotation
