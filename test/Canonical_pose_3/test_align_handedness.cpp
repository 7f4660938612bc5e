// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which poses are mirror images is known exactly if they are similar to a chiral point set or to its
// mirror image: poses of the same handedness differ by rounding only, others by the number in
// test_pose_difference.cpp. For any other poses, the result has the properties that the manual
// promises; these are checked by their definition.

#include <CGAL/Canonical_pose_3/align_handedness.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <CGAL/Random.h>


#include <gtest/gtest.h>

#include "matchers.h"
#include "point_clouds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_align_handedness {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::corner;
using Canonical_pose_test::mirrored;
using CP::Point_matrix;

// Scaled as well.
Point_matrix moved(const Point_matrix& points, const int i)
{
  return std::pow(3., i) * Canonical_pose_test::moved(points, i);
}

Point_matrix random_points(const Eigen::Index n, CGAL::Random& random)
{
  Point_matrix result(n, 3);
  for(Eigen::Index k = 0; k < result.size(); ++k)
    result.data()[k] = random.get_double(-1, 1);
  return result;
}

// All subsets of up to five poses are mirror images: the smaller part is found, regardless of position,
// orientation and scale. If both are of the same size, it is the part without the first pose.
TEST(Align_handedness, finds_the_minority)
{
  for(int k = 1; k <= 5; ++k)
    for(int subset = 0; subset < 1 << k; ++subset)
    {
      std::vector<Point_matrix> poses;
      std::vector<bool> expected;
      for(int i = 0; i < k; ++i)
      {
        expected.push_back((subset >> i) % 2 == 1);
        poses.push_back(moved(expected.back() ? mirrored(corner()) : corner(), i));
      }
      const auto number = std::count(expected.begin(), expected.end(), true);
      if(2 * number > k || (2 * number == k && expected.front()))
        expected.flip();
      EXPECT_EQ(CP::align_handedness(poses), expected) << k << ' ' << subset;
    }
}

// Each coordinate is changed by at most a thousandth of the shortest edge, so differences after alignment
// change by less than a hundredth, while those of mirror images are larger than a third.
TEST(Align_handedness, of_poses_that_are_nearly_congruent)
{
  ASSERT_GT(CP::pose_difference(corner(), mirrored(corner())), 1. / 3);
  CGAL::Random random(2);
  std::vector<Point_matrix> poses;
  std::vector<bool> expected;
  for(int i = 0; i < 9; ++i)
  {
    expected.push_back(i % 3 == 1);
    const Point_matrix pose = corner() + 1e-3 * random_points(4, random);
    EXPECT_LT(CP::pose_difference(pose, corner()), 0.01);
    poses.push_back(moved(expected.back() ? mirrored(pose) : pose, i));
  }
  EXPECT_EQ(CP::align_handedness(poses), expected);
}

// Random points are no poses of one shape: of three, each pair may be of different handedness. The
// advantage of a pair is by how much it differs less than one of them and the mirror image of the
// other. For each pose, the sum of its advantages over the others, counted negatively for those of the
// other handedness, is not negative; otherwise, the choice for it would be changed.
TEST(Align_handedness, of_contradictory_poses)
{
  constexpr std::size_t k = 12;
  CGAL::Random random(4);
  std::vector<Point_matrix> poses;
  for(std::size_t i = 0; i < k; ++i)
    poses.push_back(random_points(10, random));
  const auto advantage = [&](const std::size_t i, const std::size_t j) {
    return CP::pose_difference(mirrored(poses[i]), poses[j])
           - CP::pose_difference(poses[i], poses[j]);
  };
  bool is_contradictory = false;
  for(std::size_t i = 0; i < k; ++i)
    for(std::size_t j = 0; j < i; ++j)
      is_contradictory
        = is_contradictory || advantage(i, j) * advantage(0, i) * advantage(0, j) < -1e-9;
  EXPECT_TRUE(is_contradictory);

  const std::vector<bool> flags = CP::align_handedness(poses);
  ASSERT_EQ(flags.size(), k);
  EXPECT_LE(2 * std::count(flags.begin(), flags.end(), true), std::ptrdiff_t(k));
  for(std::size_t i = 0; i < k; ++i)
  {
    double sum = 0;
    for(std::size_t j = 0; j < k; ++j)
      if(j != i)
        sum += (flags[i] == flags[j] ? 1 : -1) * advantage(i, j);
    EXPECT_GE(sum, -1e-9) << i;
  }
}

TEST(Align_handedness, bad_input_is_named)
{
  EXPECT_THROW_WITH(CP::align_handedness({}), std::invalid_argument, "no pose");
  EXPECT_THROW_WITH(CP::align_handedness({corner(), corner().topRows(3)}), std::invalid_argument,
                    "3 and 4 points");
  EXPECT_THROW_WITH(CP::align_handedness({Point_matrix(0, 3)}), std::invalid_argument,
                    "0 and 0 points");
  EXPECT_THROW_WITH(CP::align_handedness({corner(), Point_matrix::Ones(4, 3)}),
                    std::invalid_argument, "same position");
  Point_matrix bad = corner();
  bad(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW_WITH(CP::align_handedness({corner(), bad}), std::invalid_argument, "point 2");
}

} // namespace test_align_handedness
