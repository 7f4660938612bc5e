// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Retrieval_evaluation.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_retrieval_evaluation {

namespace CP = CGAL::Canonical_pose_3;

// Distances of points on a line.
Eigen::MatrixXd on_a_line(const std::vector<double>& x)
{
  const auto n = static_cast<Eigen::Index>(x.size());
  const auto v = Eigen::VectorXd::Map(x.data(), n);
  return (v.replicate(1, n) - v.transpose().replicate(n, 1)).cwiseAbs();
}

// The answers to the first shape are 1 (its class), 2, 3 (its class), 4: everything by hand.
TEST(Retrieval_evaluation, by_hand)
{
  const CP::Retrieval_evaluation evaluation(on_a_line({0, 1, 2.1, 3.3, 4.6}), {7, 7, 2, 7, 2});
  const CP::Retrieval_measures m = evaluation.measures(0);
  EXPECT_EQ(m.nearest_neighbor, 1);
  EXPECT_EQ(m.first_tier, .5);
  EXPECT_EQ(m.second_tier, 1);
  EXPECT_DOUBLE_EQ(m.e_measure, 2 / (32. / 2 + 2. / 2));
  EXPECT_DOUBLE_EQ(m.discounted_cumulative_gain, (1 + 1 / std::log2(3.)) / (1 + 1));
  EXPECT_DOUBLE_EQ(m.average_precision, (1 + 2. / 3) / 2);

  // Answers to 4, of class 2: 3, 2 (its class), 1, 0.
  EXPECT_EQ(evaluation.measures(4).nearest_neighbor, 0);
  EXPECT_EQ(evaluation.measures(4).first_tier, 0);
  EXPECT_EQ(evaluation.measures(4).second_tier, 1);
  EXPECT_DOUBLE_EQ(evaluation.measures(4).discounted_cumulative_gain, 1);
  EXPECT_DOUBLE_EQ(evaluation.measures(4).average_precision, .5);
  EXPECT_DOUBLE_EQ(evaluation.mean_of_class(2).average_precision,
                   (evaluation.measures(2).average_precision + .5) / 2);
  EXPECT_EQ(evaluation.confusion(7, 7), 2u); // of 0 and 1; 2 is the nearest to 3
  EXPECT_EQ(evaluation.confusion(7, 2), 1u);
  EXPECT_EQ(evaluation.confusion(2, 7), 2u);
}

// If every class is apart from the others, everything is perfect but the e-measure.
TEST(Retrieval_evaluation, of_separate_classes)
{
  const CP::Retrieval_evaluation evaluation(on_a_line({0, 1, 2, 10, 11, 30}), {0, 0, 0, 1, 1, 5});
  const CP::Retrieval_measures mean = evaluation.mean();
  EXPECT_EQ(mean.nearest_neighbor, 1);
  EXPECT_EQ(mean.first_tier, 1);
  EXPECT_EQ(mean.second_tier, 1);
  EXPECT_DOUBLE_EQ(mean.discounted_cumulative_gain, 1);
  EXPECT_DOUBLE_EQ(mean.average_precision, 1);
  for(const double precision : evaluation.precision())
    EXPECT_DOUBLE_EQ(precision, 1);
  EXPECT_FALSE(evaluation.is_query(5)); // alone
}

// The precision at each recall does not increase, and at recall 1 it is the share of the class up to its
// last shape.
TEST(Retrieval_evaluation, precision_and_recall)
{
  const CP::Retrieval_evaluation evaluation(on_a_line({0, 1, 2, 3, 10, 11}), {0, 1, 0, 0, 9, 8});
  const std::vector<double>& precision = evaluation.precision();
  ASSERT_EQ(precision.size(), 20u);
  for(std::size_t i = 1; i < precision.size(); ++i)
    EXPECT_LE(precision[i], precision[i - 1]);
  // Last shapes of the class: the third answer to 0; to 2, 0 is the third; to 3, 0 is the third.
  EXPECT_DOUBLE_EQ(precision.back(), 2. / 3);
}

TEST(Retrieval_evaluation, refuses)
{
  Eigen::MatrixXd distances = on_a_line({0, 1, 2});
  EXPECT_THROW(CP::Retrieval_evaluation(distances, {0, 0}), std::invalid_argument);
  EXPECT_THROW(CP::Retrieval_evaluation(distances, {0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(CP::Retrieval_evaluation(distances.leftCols(2), {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(CP::Retrieval_evaluation(Eigen::MatrixXd(0, 0), {}), std::invalid_argument);
  distances(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CP::Retrieval_evaluation(distances, {0, 0, 0}), std::invalid_argument);
}

} // namespace test_retrieval_evaluation
