// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Results that are given to another call. With the same distances all that follows is the same computation:
// the same bytes, whatever the vertices of the surface are named inside.

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::bar;
using shapes::Polygon_soup;
using shapes::pose_of;
using shapes::Pose_result;
using shapes::small_bar;

namespace {

Pose_result pose_with_results(const Polygon_soup& soup, CP::Intermediate_results& results,
                              CP::Options options = CP::Options())
{
  options.intermediate_results = &results;
  return pose_of(soup, options);
}

// Given distances lead to the same target and pose, a given target to nearly the same pose: the iteration
// begins at the shrunk target, and ends within its tolerance.
void expect_reusable(const Polygon_soup& soup, CP::Options options = CP::Options())
{
  CP::Intermediate_results results;
  const Pose_result first = pose_with_results(soup, results, options);
  ASSERT_TRUE(results.landmark_fields && results.target);
  EXPECT_EQ(results.landmark_fields->landmarks.size(), options.number_of_landmarks);
  EXPECT_EQ(results.target->rows(), Eigen::Index(soup.points.size()));

  const CP::Intermediate_results fields{results.landmark_fields, {}, {}};
  options.given = &fields;
  const Pose_result second = pose_of(soup, options);
  EXPECT_EQ(second.pose, first.pose);
  EXPECT_EQ(second.summary.target.stress, first.summary.target.stress);

  options.given = &results;
  CP::Intermediate_results again;
  const Pose_result third = pose_with_results(soup, again, options);
  EXPECT_EQ(third.summary.target.kernel, "given");
  EXPECT_LT(shapes::relative_rms(third.pose, first.pose), 1e-3);
  EXPECT_EQ(*again.target, *results.target);
  EXPECT_EQ(again.landmark_fields->distances, results.landmark_fields->distances);
}

} // namespace

TEST(Reuse_of_results, clean_surface) { expect_reusable(bar()); }

// Vertices of the input and of the repaired surface have different names.
TEST(Reuse_of_results, isolated_vertices_in_front)
{
  for(const std::size_t number : {1, 500})
    expect_reusable(shapes::with_isolated_vertices(bar(), number));
}

TEST(Reuse_of_results, sewn_soup) { expect_reusable(shapes::unsewn(bar())); }

TEST(Reuse_of_results, largest_component)
{
  CP::Options options;
  options.components = CP::Options::Components::LARGEST;
  expect_reusable(shapes::merged(small_bar(), bar(), 20.), options);
}

// A target for each of several components comes back, no distances do.
TEST(Reuse_of_results, each_component)
{
  const Polygon_soup bars = shapes::merged(small_bar(), bar(), 20.);
  CP::Options options = shapes::each_component();
  CP::Intermediate_results results;
  const Pose_result first = pose_with_results(bars, results, options);
  EXPECT_FALSE(results.landmark_fields);
  options.given = &results;
  const Pose_result second = pose_with_results(bars, results, options);
  EXPECT_EQ(second.summary.target.kernel, "given");
  EXPECT_LT(shapes::relative_rms(second.pose, first.pose), 1e-3);
}

// The surface is cut at a vertex of two fans. What is returned has one row for both copies, the nearer distance
// and the mean target, so that a pose from it is another one, by as much as the copies are apart; that is said.
TEST(Reuse_of_results, vertex_of_two_fans)
{
  const Polygon_soup soup = shapes::renamed(bar(), 40, 42);
  CP::Intermediate_results results;
  const Pose_result first = pose_with_results(soup, results);
  EXPECT_TRUE(first.summary.warnings.empty());
  CP::Options options;
  options.given = &results;
  const Pose_result second = pose_of(soup, options);
  ASSERT_EQ(second.summary.warnings.size(), 1u);
  EXPECT_NE(second.summary.warnings[0].find("is not manifold at vertex"), std::string::npos)
    << second.summary.warnings[0];
  EXPECT_LT(shapes::relative_rms(second.pose, first.pose), 0.02);
}

// What an earlier call left in the structure has no influence.
TEST(Reuse_of_results, structure_of_another_mesh)
{
  Polygon_soup other = bar();
  for(auto& p : other.points)
    p[1] *= 3;
  CP::Intermediate_results results, fresh;
  pose_with_results(bar(), results);
  const Pose_result pose = pose_with_results(other, results);
  EXPECT_EQ(pose_with_results(other, fresh).pose, pose.pose);
  EXPECT_EQ(results.landmark_fields->distances, fresh.landmark_fields->distances);
  EXPECT_EQ(*results.target, *fresh.target);
}

// The rest pose as target has no energy.
TEST(Reuse_of_results, own_target)
{
  CP::Intermediate_results given;
  given.target = shapes::to_matrix(bar().points);
  CP::Options options;
  options.given = &given;
  EXPECT_LT(pose_of(bar(), options).summary.energy, 1e-16);
}

// Messages name rows and vertices of the input, not those of the surface inside.
TEST(Reuse_of_results, what_does_not_fit_is_named)
{
  const Polygon_soup soup = shapes::with_isolated_vertices(bar(), 3);
  CP::Intermediate_results results;
  pose_with_results(soup, results);
  const auto expect_refused = [&](const CP::Intermediate_results& given, const char* const text) {
    CP::Options options;
    options.given = &given;
    EXPECT_THROW_WITH(pose_of(soup, options), std::invalid_argument, text);
  };
  CP::Intermediate_results given = results;
  given.target->conservativeResize(5, 3);
  expect_refused(given, "the given target has 5 rows");
  given = results;
  (*given.target)(7, 1) = std::numeric_limits<double>::quiet_NaN();
  expect_refused(given, "the given target of vertex 7 is not finite");
  given = results;
  given.landmark_fields->distances.conservativeResize(7, 80);
  expect_refused(given, "the given distances have 7 rows");
  given.landmark_fields = CP::Landmark_fields_3();
  expect_refused(given, "no column");
  given = results;
  given.landmark_fields->landmarks[4] = soup.points.size();
  expect_refused(given, "landmark is vertex");
  given.landmark_fields->landmarks[4] = 1;
  expect_refused(given, "landmark vertex 1 is not on the surface");
  given.landmark_fields->landmarks.pop_back();
  expect_refused(given, "79 given landmarks");
  given = results;
  given.landmark_fields->distances(9, 2) = -1;
  expect_refused(given, "the given distance of vertex 9 to landmark");
}
