// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/canonical_pose_3.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include "Articulated_figure.h"
#include "bent_bars.h"
#include "matchers.h"
#include "point_clouds.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_canonical_frame {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using Canonical_pose_examples::Articulated_figure;
using CP::Point_matrix;

const Eigen::Isometry3d motion = Eigen::Translation3d(30, -10, 20)
                                 * Eigen::AngleAxisd(2.2, Eigen::Vector3d(1, 3, -2).normalized());

Point_matrix moved(const Point_matrix& points, const Eigen::Isometry3d& by = motion)
{
  return (by * points.transpose()).transpose();
}

Point_matrix framed(const Point_matrix& points, const Eigen::VectorXd& weights)
{
  return moved(points, CP::canonical_frame(points, weights));
}

CP::Options in_canonical_frame()
{
  CP::Options options;
  options.frame = CP::Options::Frame::CANONICAL;
  return options;
}

// The frame of a random point set is unique, so it follows any rigid motion up to rounding.
TEST(Canonical_frame, of_points)
{
  const Point_matrix points = shapes::random_points(50, 3, 1).array().square().matrix()
                              * Eigen::Vector3d(1, 3, 2).asDiagonal();
  const Eigen::VectorXd weights = shapes::random_points(50, 1, 2).array().square();
  const Point_matrix expected = framed(points, weights);
  EXPECT_LT((framed(moved(points), weights) - expected).norm(), 1e-12 * points.norm());
  EXPECT_LT((framed(1e150 * points, weights) - 1e150 * expected).norm() / 1e150, 1e-12);
  EXPECT_NEAR(CP::canonical_frame(points, weights).linear().determinant(), 1, 1e-14);

  // The definition: centroid 0, covariance diagonal with decreasing entries, moment.
  EXPECT_LT((expected.transpose() * weights).norm(), 1e-12);
  const Eigen::Matrix3d covariance = expected.transpose() * weights.asDiagonal() * expected;
  EXPECT_LT((covariance - Eigen::Matrix3d(covariance.diagonal().asDiagonal())).norm(), 1e-12);
  EXPECT_GT(covariance(0, 0), covariance(1, 1));
  EXPECT_GT(covariance(1, 1), covariance(2, 2));
  const Eigen::Vector3d moment
    = expected.transpose() * weights.cwiseProduct(expected.rowwise().norm());
  EXPECT_GE(moment.minCoeff(), -moment.cwiseAbs().minCoeff());
  EXPECT_GT((moment.array() > 0).count(), 1);
}

// Across the plane of symmetry the moment is 0, whose sign is noise: it must not matter.
TEST(Canonical_frame, of_a_symmetric_shape)
{
  Point_matrix points(6, 3);
  points << 5, 0, 0, -5, 0, 0, 0, 2, 0, 0, -1, 0, 0, 0, .5, 0, -.1, -.2; // symmetric in x
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(6);
  const Point_matrix expected = framed(points, weights);
  for(int i = 1; i <= 20; ++i)
  {
    Point_matrix noisy = points;
    noisy(0, 0) += 1e-9 * (i % 2 == 0 ? i : -i);
    EXPECT_LT((framed(moved(noisy), weights) - expected).norm(), 1e-6);
  }
}

TEST(Canonical_frame, of_degenerate_points)
{
  EXPECT_TRUE(framed(Point_matrix::Ones(3, 3), Eigen::VectorXd::Ones(3)).isZero(1e-15));
  Point_matrix line(3, 3);
  line << 0, 0, 0, 0, 1, 0, 0, 5, 0;
  EXPECT_NEAR(framed(line, Eigen::VectorXd::Ones(3))(2, 0), 3, 1e-14);

  EXPECT_THROW(CP::canonical_frame(line, Eigen::VectorXd::Zero(3)), std::invalid_argument);
  EXPECT_THROW(CP::canonical_frame(Point_matrix(0, 3), Eigen::VectorXd(0)), std::invalid_argument);
  line(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CP::canonical_frame(line, Eigen::VectorXd::Ones(3)), std::invalid_argument);
}

// The pose in its frame is the pose, moved rigidly, and with it the followers. The target stays where
// it was; the motion that is returned leads from there to the pose.
TEST(Canonical_frame, of_the_call)
{
  const auto soup = shapes::bent_bar();
  CP::Options options;
  options.followers = shapes::random_points(5, 3, 3);
  const CP::Result result = shapes::pose_of(soup, options);
  options.frame = CP::Options::Frame::CANONICAL;
  const CP::Result framed = shapes::pose_of(soup, options);
  const Point_matrix all[2] = {(Point_matrix(2 * result.pose.rows() + 5, 3) << result.pose,
                                *result.target, result.pose_of_followers)
                                 .finished(),
                               (Point_matrix(2 * result.pose.rows() + 5, 3) << framed.pose,
                                moved(*framed.target, framed.motion), framed.pose_of_followers)
                                 .finished()};
  EXPECT_EQ(*framed.target, *result.target);
  EXPECT_TRUE(result.motion.isApprox(Eigen::Isometry3d::Identity(), 0));
  EXPECT_LT(CP::pose_difference(all[0], all[1]), 1e-12);
  EXPECT_LT(framed.pose.colwise().mean().norm(), .1 * shapes::radius_of_gyration(framed.pose));

  // Also for complexes, and with several components.
  const auto bar = shapes::tetrahedral_bent_bar(16, 3, 2, 2.5, {{8., 1.5, 1.}});
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CP::Indexed_tetrahedra_3<Point> complex;
  for(const auto& p : bar.points)
    complex.points.emplace_back(p[0], p[1], p[2]);
  complex.cells = bar.cells;
  std::vector<Point> pose(complex.points.size());
  const CP::Result of_complex
    = CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), in_canonical_frame());
  EXPECT_LT(of_complex.pose.colwise().mean().norm(), .2);
  CP::Options each = shapes::each_component();
  const CP::Result apart = shapes::pose_of(shapes::two_bars(), each);
  each.frame = CP::Options::Frame::CANONICAL;
  const CP::Result apart_framed = shapes::pose_of(shapes::two_bars(), each);
  EXPECT_LT(CP::pose_difference(apart.pose, apart_framed.pose), 1e-12);
}

// Poses of the same figure lie on each other, wherever the figure is and however it stands: without
// alignment they differ by little more than with it. A turn by an angle t moves points by at most
// 2 sin(t / 2) times their distance from the center; principal axes of two poses enclose less than six
// degrees. Head and feet tell the direction of the longest axis; left and right, front and back are
// alike, so a half turn around it remains.
TEST(Canonical_frame, makes_alignment_unnecessary)
{
  const Articulated_figure figure(4000);
  std::vector<Point_matrix> poses;
  for(const auto& named : Articulated_figure::named_poses())
  {
    Point_matrix points = shapes::to_matrix(figure.points(named.angles));
    if(poses.size() % 2 == 1)
      points = moved(points);
    std::vector<CGAL::Simple_cartesian<double>::Point_3> input, pose;
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      input.emplace_back(points(i, 0), points(i, 1), points(i, 2));
    poses.push_back(
      CGAL::canonical_pose_3(input, figure.triangles(), pose, in_canonical_frame()).pose);
  }
  ASSERT_GE(poses.size(), 2u);
  for(std::size_t i = 1; i < poses.size(); ++i)
  {
    const double aligned = CP::pose_difference(poses[0], poses[i]);
    const auto difference = [&](const Point_matrix& other) {
      return std::sqrt((poses[0] - other).rowwise().squaredNorm().mean())
             / shapes::radius_of_gyration(poses[0]);
    };
    const Point_matrix turned = poses[i] * Eigen::Vector3d(1, -1, -1).asDiagonal();
    EXPECT_LT((std::min)(difference(poses[i]), difference(turned)), aligned + 2 * std::sin(3 * CGAL_PI / 180)) << i;
  }
}

} // namespace test_canonical_frame
