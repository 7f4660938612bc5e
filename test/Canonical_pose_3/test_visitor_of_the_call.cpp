// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The visitor of the one call.

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <cstddef>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_visitor_of_the_call {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using CP::Registration_summary;

// Geodesics around a ball make its target too large: it is registered twice, after once per round.
// Iterations are numbered consecutively, with one call each. Stopping in the first registration skips
// the others. Rounds are numbered from 1; the last registration has the number 0.
TEST(Visitor_of_the_one_call, counts_all_iterations)
{
  const shapes::Triangle_soup ball = shapes::icosphere_soup(3, 1.);
  CP::Options options;
  for(const int rounds : {0, 2})
  {
    options.number_of_rounds = rounds;
    options.visitor = nullptr;
    const Point_matrix expected = shapes::pose_of(ball, options).pose;
    int calls = 0;
    std::vector<int> seen;
    options.visitor = [&](const CP::Registration_progress& progress) {
      EXPECT_EQ(progress.iteration, ++calls);
      EXPECT_EQ(progress.component, 0u);
      if(seen.empty() || seen.back() != progress.round)
        seen.push_back(progress.round);
      return true;
    };
    const shapes::Result watched = shapes::pose_of(ball, options);
    EXPECT_LT(watched.summary.target.scale, 1);
    EXPECT_EQ(calls, watched.summary.iterations);
    EXPECT_EQ(watched.summary.rounds.empty(), rounds == 0);
    std::vector<int> expected_rounds(watched.summary.rounds.size());
    std::iota(expected_rounds.begin(), expected_rounds.end(), 1);
    expected_rounds.push_back(0);
    EXPECT_EQ(seen, expected_rounds);
    EXPECT_TRUE(watched.pose == expected);
  }
  options.visitor = [](const CP::Registration_progress&) { return false; };
  const shapes::Result stopped = shapes::pose_of(ball, options);
  EXPECT_EQ(stopped.summary.iterations, 1);
  EXPECT_EQ(stopped.summary.target.scale, 1);
  EXPECT_TRUE(stopped.summary.rounds.empty());
  EXPECT_TRUE(stopped.pose.allFinite());
  EXPECT_NE(stopped.summary.warnings.back().find("canceled"), std::string::npos);
}

// After stopping a component, the next one starts: all have a pose.
TEST(Visitor_of_the_one_call, stops_each_component)
{
  const shapes::Triangle_soup bars = shapes::two_bars();
  CP::Options options = shapes::each_component();
  std::set<std::size_t> components;
  options.visitor = [&](const CP::Registration_progress& progress) {
    components.insert(progress.component);
    return progress.iteration < 3;
  };
  const shapes::Result result = shapes::pose_of(bars, options);
  EXPECT_EQ(result.summary.termination, Registration_summary::CANCELED);
  EXPECT_EQ(result.summary.iterations, 6);
  EXPECT_EQ(components, (std::set<std::size_t>{0, 1}));
  for(const Point_matrix& bar : {Point_matrix(result.pose.topRows(result.pose.rows() / 2)),
                                 Point_matrix(result.pose.bottomRows(result.pose.rows() / 2))})
    EXPECT_GT(shapes::radius_of_gyration(bar), 1);
}

TEST(Visitor_of_the_one_call, exception_passes_through)
{
  CP::Options options;
  options.visitor
    = [](const CP::Registration_progress&) -> bool { throw std::runtime_error("enough"); };
  EXPECT_THROW_WITH(shapes::pose_of(shapes::bent_bar(), options), std::runtime_error, "enough");
}

} // namespace test_visitor_of_the_call
