// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Of rigid copies, and of boxes along the axes, the mean is known exactly. Of any poses, it is the same whatever their
// positions, orientations and order are, and no pose nearby has a smaller sum of squared differences.

#include <CGAL/Canonical_pose_3/mean_pose.h>


#include <gtest/gtest.h>

#include "matchers.h"
#include "point_clouds.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_mean_pose {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::corner;
using Canonical_pose_test::mirrored;
using Canonical_pose_test::moved;
using Canonical_pose_test::random_points;
using CP::Point_matrix;

// The corners of a box around the origin.
Point_matrix box(const double x, const double y, const double z)
{
  Point_matrix points(8, 3);
  for(Eigen::Index i = 0; i < 8; ++i)
    points.row(i) << (i & 1 ? x : -x), (i & 2 ? y : -y), (i & 4 ? z : -z);
  return points;
}

// Similar shapes, moved.
std::vector<Point_matrix> variants(const int number)
{
  std::vector<Point_matrix> result;
  const Point_matrix shape = random_points(20, 3);
  for(int i = 0; i < number; ++i)
    result.push_back(
      moved(shape + .3 * random_points(20, 3, 10 + static_cast<unsigned int>(i)), i));
  return result;
}

double largest_difference(const Point_matrix& a, const Point_matrix& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

// The sum of squared distances after the best rigid motions.
double sum_of_squares(const std::vector<Point_matrix>& poses, const Point_matrix& mean)
{
  double sum = 0;
  for(const Point_matrix& pose : poses)
    sum += (CP::align_target(pose, mean, Eigen::VectorXd::Ones(pose.rows())) - mean).squaredNorm();
  return sum;
}

// In any unit; only rounding errors remain.
TEST(Mean_pose, of_rigid_copies)
{
  for(const double unit : {1., 1e250, 1e-250})
    for(const int number : {1, 2, 7})
    {
      std::vector<Point_matrix> poses;
      for(int i = 0; i < number; ++i)
        poses.push_back(unit * moved(corner(), i));
      EXPECT_LT(largest_difference(CP::mean_pose(poses), poses.front()), 1e-13 * unit) << number;
    }
}

// Alignment leaves boxes along the axes as they are: edges of the mean are means of edges. They are not scaled before.
TEST(Mean_pose, of_boxes)
{
  const Point_matrix mean
    = CP::mean_pose({box(3, 2, 1), moved(box(3, 8, 4), 1), moved(box(6, 2, 4), 2)});
  EXPECT_LT(largest_difference(mean, box(4, 4, 3)), 1e-5);
}

TEST(Mean_pose, is_the_same_for_poses_that_are_moved)
{
  const std::vector<Point_matrix> poses = variants(6);
  const Point_matrix mean = CP::mean_pose(poses);
  std::vector<Point_matrix> others = poses;
  for(int i = 1; i < 6; ++i)
    others[static_cast<std::size_t>(i)] = moved(others[static_cast<std::size_t>(i)], 3 * i);
  EXPECT_LT(largest_difference(CP::mean_pose(others), mean), 1e-12); // it is where the first one is
  others.front() = moved(others.front(), 5);
  EXPECT_LT(largest_difference(CP::mean_pose(others), moved(mean, 5)), 1e-12);
}

TEST(Mean_pose, is_the_same_in_any_order)
{
  const std::vector<Point_matrix> poses = variants(6);
  const Point_matrix mean = CP::mean_pose(poses),
                     other = CP::mean_pose({poses.rbegin(), poses.rend()});
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(mean.rows());
  EXPECT_LT(largest_difference(CP::align_target(other, mean, weights), mean), 1e-5);
}

TEST(Mean_pose, is_nearest_to_all)
{
  const std::vector<Point_matrix> poses = variants(6);
  const Point_matrix mean = CP::mean_pose(poses);
  const double least = sum_of_squares(poses, mean);
  for(unsigned int i = 0; i < 20; ++i)
    EXPECT_GT(sum_of_squares(poses, mean + 1e-3 * random_points(mean.rows(), 3, i)), least);
  for(const Point_matrix& pose : poses)
    EXPECT_GT(sum_of_squares(poses, pose), least);
}

// A mirror image is another shape: the mean is half way to it.
TEST(Mean_pose, does_not_reflect)
{
  const Point_matrix mean = CP::mean_pose({corner(), mirrored(corner())});
  const double difference = CP::pose_difference(mean, corner());
  EXPECT_NEAR(difference, CP::pose_difference(mean, mirrored(corner())), 1e-5);
  EXPECT_GT(difference, CP::pose_difference(corner(), mirrored(corner())) / 3);
}

TEST(Mean_pose, of_a_point)
{
  const Point_matrix point = Point_matrix::Constant(4, 3, 2);
  EXPECT_EQ(CP::mean_pose({point, 3 * point}), point);
}

TEST(Mean_pose, bad_input_is_named)
{
  EXPECT_THROW_WITH(CP::mean_pose({}), std::invalid_argument, "no pose");
  EXPECT_THROW_WITH(CP::mean_pose({corner(), corner().topRows(3)}), std::invalid_argument,
                    "3 and 4 points");
  EXPECT_THROW_WITH(CP::mean_pose({Point_matrix(0, 3)}), std::invalid_argument, "0 and 0 points");
  Point_matrix bad = corner();
  bad(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW_WITH(CP::mean_pose({corner(), bad}), std::invalid_argument, "vertex 2");
}

} // namespace test_mean_pose
