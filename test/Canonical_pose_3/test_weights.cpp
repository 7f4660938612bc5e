// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "conforming_bar.h"
#include "matchers.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace test_weights {

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;
using Eigen::VectorXd;

// A vertex of weight 0 has no target: the given position does not matter, bit by bit.
TEST(Weights, zero_is_no_target)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  Point_matrix target = conforming_bar(1.).points();
  VectorXd weights = uniform_weights(target);
  weights[20] = 0;
  const Point_matrix pose = register_bar(body, target, weights).pose;
  target.row(20) += Eigen::RowVector3d(10, 20, 30);
  EXPECT_EQ(register_bar(body, target, weights).pose, pose);
  weights[20] = 1e-3;
  EXPECT_GT((register_bar(body, target, weights).pose - pose).norm(), 1e-3);
}

// Weights are divided by their sum; a factor of 2 changes no digit.
TEST(Weights, common_factor_does_not_matter)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const Point_matrix target = conforming_bar(1.).points();
  VectorXd weights = VectorXd::LinSpaced(target.rows(), 1, 3);
  const Point_matrix pose = register_bar(body, target, weights).pose;
  EXPECT_EQ(register_bar(body, target, 2 * weights).pose, pose);
  EXPECT_LT((register_bar(body, target, 3 * weights).pose - pose).norm(), 1e-10);
}

TEST(Weights, bad_factors_are_named)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const VectorXd weights = uniform_weights(body.points());
  const auto make = [&](const VectorXd& w, const VectorXd& stiffness) {
    register_bar(body, body.points(), w, {}, stiffness);
  };
  VectorXd bad = cells_with(body, 1);
  EXPECT_THROW_WITH(make(weights, VectorXd::Ones(3)), std::invalid_argument,
                    "3 numbers are given as stiffness, but it takes " + std::to_string(bad.size())
                      + ", one per cell");
  for(const double value : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()})
  {
    bad[17] = value;
    EXPECT_THROW_WITH(make(weights, bad), std::invalid_argument, "the stiffness of cell 17 is ");
  }
  EXPECT_THROW(make(VectorXd::Zero(weights.size()), VectorXd()), std::invalid_argument);
}

} // namespace test_weights
