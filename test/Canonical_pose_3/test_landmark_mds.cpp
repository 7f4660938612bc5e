// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Power_kernel.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "point_clouds.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test_landmark_mds {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::euclidean_fields;
using Canonical_pose_test::largest_distance_error;
using Canonical_pose_test::random_points;

// Classical scaling is exact on Euclidean distances: the centered kernel matrix is then the Gram
// matrix of the landmarks, of rank 3, and interpolation recovers every other point. Only rounding
// errors remain. This verifies all constants.
TEST(Landmark_mds, recovers_a_cloud_from_its_distances)
{
  const Eigen::MatrixXd points = random_points(200, 3);
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(euclidean_fields(points, 20));
  EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-10);
  EXPECT_LT(builder.stress(), 1e-7);
  EXPECT_EQ(builder.number_of_positive_eigenvalues(), 3);
  EXPECT_LT(builder.eigenvalues()[3], 1e-10 * builder.eigenvalues()[0]);
  EXPECT_TRUE(builder.is_determined());
}

// If the distances are Euclidean ones to the power of 2/p, then the kernel matrix of exponent p is that
// of classical scaling for the Euclidean ones, up to a factor, so the cloud is recovered up to its
// scale. Only rounding errors remain.
TEST(Landmark_mds, recovers_a_cloud_from_powers_of_its_distances)
{
  const Eigen::MatrixXd points = random_points(200, 3);
  for(const double p : {1., 1.5, 2., 3.})
  {
    CP::Landmark_fields_3 fields = euclidean_fields(points, 20);
    fields.distances = fields.distances.array().pow(2 / p).matrix();
    CP::Landmark_mds_target_builder_3<CP::Power_kernel> builder{CP::Power_kernel(p)};
    builder.build(fields);
    EXPECT_LT(CP::pose_difference(builder.targets(), points, true), 1e-9) << "p = " << p;
    EXPECT_EQ(builder.number_of_positive_eigenvalues(), 3) << "p = " << p;
  }
}

// In any order, the embedded landmarks of a point cloud have the given distances.
TEST(Landmark_mds, landmark_targets)
{
  CP::Landmark_fields_3 fields = euclidean_fields(random_points(40, 3), 12);
  std::reverse(fields.landmarks.begin(), fields.landmarks.end());
  fields.distances = fields.distances.rowwise().reverse().eval();
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(fields);
  const Eigen::MatrixXd& x = builder.landmark_targets();
  ASSERT_EQ(x.rows(), 12);
  for(Eigen::Index i = 0; i < 12; ++i)
    for(Eigen::Index j = 0; j < 12; ++j)
      EXPECT_NEAR((x.row(i) - x.row(j)).norm(),
                  fields.distances(Eigen::Index(fields.landmarks[std::size_t(i)]), j), 1e-10);
}

// Distances of points in the plane have a Gram matrix of rank 2: the third coordinate must be
// exactly 0, not noise.
TEST(Landmark_mds, flat_data_stay_flat)
{
  const Eigen::MatrixXd points = random_points(100, 2);
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(euclidean_fields(points, 15));
  EXPECT_EQ(builder.number_of_positive_eigenvalues(), 2);
  EXPECT_EQ(builder.targets().col(2).cwiseAbs().maxCoeff(), 0.);
  EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-10);
}

// Interpolating a landmark is Lambda^(-1/2) Q^t K H e_j = Lambda^(1/2) Q^t e_j, its own position,
// for any symmetric kernel matrix; here the dense embedding is computed separately by this formula.
TEST(Landmark_mds, landmarks_agree_with_their_interpolation)
{
  const CP::Landmark_fields_3 fields = euclidean_fields(random_points(30, 5), 30);
  CP::Landmark_mds_target_builder_3<CP::Gaussian_kernel> builder;
  builder.build(fields);
  const double length = fields.distances.maxCoeff();
  Eigen::MatrixXd k = (-2 * fields.distances.array().square() / (length * length)).exp();
  const Eigen::MatrixXd h
    = Eigen::MatrixXd::Identity(30, 30) - Eigen::MatrixXd::Constant(30, 30, 1. / 30);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(h * k * h);
  const Eigen::MatrixXd embedded
    = solver.eigenvectors().rightCols(3) * solver.eigenvalues().tail(3).cwiseSqrt().asDiagonal();
  double dg = 0, dd = 0;
  for(int i = 0; i < 30; ++i)
    for(int j = 0; j < i; ++j)
    {
      const double d = (embedded.row(i) - embedded.row(j)).norm();
      dg += d * fields.distances(i, j);
      dd += d * d;
    }
  EXPECT_LT(largest_distance_error(builder.targets(), embedded * (dg / dd)), 1e-12 * length);
}

// Multiplying all distances by a power of two multiplies the target by it, bit by bit.
TEST(Landmark_mds, scales_exactly)
{
  CP::Landmark_fields_3 fields = euclidean_fields(random_points(50, 4), 12);
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(fields);
  const Eigen::MatrixXd before = builder.targets();
  fields.distances *= 1024;
  builder.build(fields);
  EXPECT_EQ(builder.targets(), before * 1024);
}

TEST(Landmark_mds, few_and_coinciding_landmarks)
{
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(euclidean_fields(random_points(5, 3), 1));
  EXPECT_EQ(builder.targets(), Eigen::MatrixXd::Zero(5, 3));
  EXPECT_EQ(builder.stress(), 0.);

  const Eigen::MatrixXd points = random_points(40, 3);
  CP::Landmark_fields_3 fields = euclidean_fields(points, 10);
  fields.landmarks.push_back(0);
  fields.distances.conservativeResize(40, 11);
  fields.distances.col(10) = fields.distances.col(0);
  builder.build(fields);
  EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-10);
}

// A kernel with a pole: at distance 0, which occurs for each landmark, and at distances between
// other points only.
TEST(Landmark_mds, kernel_that_is_not_finite_is_named)
{
  struct Pole
  {
    double at;
    double operator()(const double r) const { return 1 / std::abs(r - at); }
    bool is_centered() const { return true; }
    const char* name() const { return "pole"; }
  };
  Eigen::MatrixXd points(4, 3);
  points << 0, 0, 0, 4, 0, 0, 0, 4, 0, 2, 0, 0;
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 3);
  for(const double at : {0., fields.distances(3, 0) / fields.distances.maxCoeff()})
  {
    CP::Landmark_mds_target_builder_3<Pole> builder(Pole{at});
    EXPECT_THROW_WITH(builder.build(fields), std::invalid_argument, "kernel pole is not finite");
  }
}

TEST(Landmark_mds, bad_distances_are_named)
{
  CP::Landmark_mds_target_builder_3<> builder;
  CP::Landmark_fields_3 fields = euclidean_fields(random_points(9, 3), 4);
  fields.distances(7, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THROW_WITH(builder.build(fields), std::invalid_argument,
                    "vertex 7 to landmark 2 is not finite");
  fields.distances(7, 2) = -1;
  EXPECT_THROW_WITH(builder.build(fields), std::invalid_argument, "negative");
  fields.distances(7, 2) = 1;
  fields.landmarks[3] = 9;
  EXPECT_THROW_WITH(builder.build(fields), std::invalid_argument,
                    "have landmark 9, but there are 9 vertices");
  fields.landmarks.pop_back();
  EXPECT_THROW_WITH(builder.build(fields), std::invalid_argument,
                    "have 3 landmarks, but 4 columns");
  EXPECT_THROW_WITH(builder.build(CP::Landmark_fields_3()), std::invalid_argument,
                    "have no column");
  EXPECT_THROW_WITH(CP::Landmark_mds_target_builder_3<>(CP::Squared_distance_kernel(), 0),
                    std::invalid_argument, "option dimension is 0");
}

} // namespace test_landmark_mds
