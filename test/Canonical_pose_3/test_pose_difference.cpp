// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "matchers.h"
#include "point_clouds.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace test_pose_difference {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::corner;
using Canonical_pose_test::mirrored;
using CP::Point_matrix;

// Position, orientation and scale do not count, in any unit; only rounding errors remain.
TEST(Pose_difference, congruent_poses)
{
  const Eigen::Matrix3d turn
    = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  for(const double scale : {1., 0.37, 1e250, 1e-250})
  {
    const Point_matrix moved
      = scale * ((corner() * turn.transpose()).rowwise() + Eigen::RowVector3d(5, -3, 1));
    EXPECT_LT(CP::pose_difference(corner(), moved), 1e-14) << scale;
    EXPECT_LT(CP::pose_difference(moved, corner(), true), 1e-14) << scale;
    EXPECT_LT(CP::pose_difference(mirrored(moved), corner(), true), 1e-14) << scale;
  }
}

// Uncorrelated poses are a distance of sqrt(2) apart, as the squares of their radii add up.
TEST(Pose_difference, largest_value)
{
  Point_matrix a = Point_matrix::Zero(4, 3), b = a;
  a.col(0) << 1, -1, 1, -1;
  b.col(0) << 1, 1, -1, -1;
  EXPECT_NEAR(CP::pose_difference(a, b), std::sqrt(2.), 1e-15);
  EXPECT_NEAR(CP::pose_difference(a, b, true), std::sqrt(2.), 1e-15);
}

// The covariance of centered points and their mirror image has the singular values s of that of the
// points, and the determinant is negative: the best rotation has the trace s1 + s2 - s3, of s1 + s2
// + s3 = 1.
TEST(Pose_difference, mirror_image)
{
  Point_matrix centered = corner();
  centered.rowwise() -= centered.colwise().mean().eval();
  const Eigen::Matrix3d covariance = centered.transpose() * centered;
  const double share = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues()[0]
                       / covariance.trace();
  EXPECT_NEAR(CP::pose_difference(corner(), mirrored(corner())), std::sqrt(4 * share), 1e-14);
}

TEST(Pose_difference, mean)
{
  const Point_matrix a = corner(), b = mirrored(a);
  const double difference = CP::pose_difference(a, b);
  EXPECT_NEAR(CP::mean_pose_difference({a, b, 2 * a}), 2. / 3 * difference, 1e-14);
  EXPECT_LT(CP::mean_pose_difference({a, b, 2 * a}, true), 1e-14);
}

TEST(Pose_difference, bad_input_is_named)
{
  Point_matrix bad = corner();
  bad(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW_WITH(CP::pose_difference(corner(), bad), std::invalid_argument, "point 2");
  EXPECT_THROW_WITH(CP::pose_difference(corner(), corner().topRows(3)), std::invalid_argument,
                    "4 and 3 points");
  EXPECT_THROW_WITH(CP::pose_difference(Point_matrix(0, 3), Point_matrix(0, 3)),
                    std::invalid_argument, "0 and 0 points");
  EXPECT_THROW_WITH(CP::pose_difference(corner(), Point_matrix::Ones(4, 3)), std::invalid_argument,
                    "same position");
  EXPECT_THROW_WITH(CP::mean_pose_difference({corner()}), std::invalid_argument, "two poses");
}

} // namespace test_pose_difference
