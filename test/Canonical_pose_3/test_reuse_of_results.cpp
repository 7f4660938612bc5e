// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Results that are passed to another call. With the same distances, all subsequent computations are
// the same: the same bytes, regardless of internal vertex indices.

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

namespace test_reuse_of_results {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::bar;
using shapes::Polygon_soup;
using shapes::pose_of;
using shapes::Result;
using shapes::small_bar;

Result pose_with_fields(const Polygon_soup& soup, CP::Options options = CP::Options())
{
  options.return_landmark_fields = true;
  return pose_of(soup, options);
}

// Given distances lead to the same target and pose. A given target, that of the last round, leads to
// nearly the same pose without rounds: the iteration starts at the shrunk target, and ends within its
// tolerance, which is therefore small here.
void expect_reusable(const Polygon_soup& soup, CP::Options options = CP::Options())
{
  options.registration.energy_tolerance = 1e-8;
  options.registration.move_tolerance = 1e-5;
  const Result first = pose_with_fields(soup, options);
  ASSERT_TRUE(first.landmark_fields && first.target);
  EXPECT_EQ(first.landmark_fields->landmarks.size(), options.number_of_landmarks);
  EXPECT_EQ(first.target->rows(), Eigen::Index(soup.points.size()));

  options.given.landmark_fields = first.landmark_fields;
  const Result second = pose_of(soup, options);
  EXPECT_FALSE(second.landmark_fields);
  EXPECT_EQ(second.pose, first.pose);
  EXPECT_EQ(second.summary.target.stress, first.summary.target.stress);
  EXPECT_FALSE(first.summary.rounds.empty());
  EXPECT_EQ(second.summary.rounds.size(), first.summary.rounds.size());

  options.given = first;
  const Result third = pose_with_fields(soup, options);
  EXPECT_EQ(third.summary.target.kernel, "given");
  EXPECT_TRUE(third.summary.rounds.empty());
  EXPECT_LT(shapes::relative_rms(third.pose, first.pose), 1e-3);
  EXPECT_EQ(*third.target, *first.target);
  EXPECT_EQ(third.landmark_fields->distances, first.landmark_fields->distances);
}

TEST(Reuse_of_results, clean_surface) { expect_reusable(bar()); }

// Vertices of the input and of the repaired surface have different indices.
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

// A target is returned for each of several components, but no distances.
TEST(Reuse_of_results, each_component)
{
  const Polygon_soup bars = shapes::merged(small_bar(), bar(), 20.);
  CP::Options options = shapes::each_component();
  const Result first = pose_with_fields(bars, options);
  EXPECT_FALSE(first.landmark_fields);
  options.given = first;
  const Result second = pose_with_fields(bars, options);
  EXPECT_EQ(second.summary.target.kernel, "given");
  EXPECT_LT(shapes::relative_rms(second.pose, first.pose), 1e-3);
}

// The surface is split at a vertex of two fans. The result has one row for both copies, with the
// smaller distance and the mean target, so a pose computed from it differs by about the distance
// between the copies; this is reported.
TEST(Reuse_of_results, vertex_of_two_fans)
{
  const Polygon_soup soup = shapes::renamed(bar(), 40, 42);
  const Result first = pose_with_fields(soup);
  EXPECT_EQ(first.summary.warnings.size(), 1u); // of the repair
  CP::Options options;
  options.given = first;
  const Result second = pose_of(soup, options);
  ASSERT_EQ(second.summary.warnings.size(), 2u);
  EXPECT_NE(second.summary.warnings[1].find("is not manifold at vertex"), std::string::npos)
    << second.summary.warnings[1];
  EXPECT_LT(shapes::relative_rms(second.pose, first.pose), 0.02);
}

// Whatever the frames of both calls, the target is where it was, so the poses of the second call are
// the same, bit for bit, also after a call between them; and they are where a call that is not given a
// target brings them. The bars are far from the origin.
TEST(Reuse_of_results, in_any_frame)
{
  using Frame = CP::Options::Frame;
  const Polygon_soup bars = shapes::merged(small_bar(), bar(), 20.);
  CP::Options options = shapes::each_component();
  options.registration.energy_tolerance = 1e-8;
  options.registration.move_tolerance = 1e-5;
  options.followers = Point_matrix::Ones(1, 3);
  const auto pose_in = [&](const Frame frame, const CP::Intermediate_results& given) {
    options.frame = frame;
    options.given = given;
    return pose_of(bars, options);
  };
  const double size = shapes::radius_of_gyration(shapes::to_matrix(bars.points));
  const Result first[2] = {pose_in(Frame::INPUT, {}), pose_in(Frame::CANONICAL, {})};
  for(const Frame to : {Frame::INPUT, Frame::CANONICAL})
  {
    const Result expected = pose_in(to, first[0]);
    EXPECT_LT((expected.pose - first[to == Frame::INPUT ? 0 : 1].pose).rowwise().norm().maxCoeff(), 1e-2 * size);
    for(const Result& from : first)
      for(const Frame between : {Frame::INPUT, Frame::CANONICAL})
      {
        const Result last = pose_in(to, pose_in(between, from));
        EXPECT_EQ(last.pose, expected.pose);
        EXPECT_EQ(last.pose_of_followers, expected.pose_of_followers);
        EXPECT_EQ(*last.target, *first[0].target);
      }
  }
}

// The rest pose as target has energy 0.
TEST(Reuse_of_results, own_target)
{
  CP::Options options;
  options.given.target = shapes::to_matrix(bar().points);
  EXPECT_LT(pose_of(bar(), options).summary.energy, 1e-16);
}

// Messages refer to rows and vertices of the input, not of the repaired surface.
TEST(Reuse_of_results, what_does_not_fit_is_named)
{
  const Polygon_soup soup = shapes::with_isolated_vertices(bar(), 3);
  const Result result = pose_with_fields(soup);
  const auto expect_refused = [&](const CP::Intermediate_results& given, const char* const text) {
    CP::Options options;
    options.given = given;
    EXPECT_THROW_WITH(pose_of(soup, options), std::invalid_argument, text);
  };
  CP::Intermediate_results given = result;
  given.target->conservativeResize(5, 3);
  expect_refused(given, "the given target has 5 rows");
  given = result;
  (*given.target)(7, 1) = std::numeric_limits<double>::quiet_NaN();
  expect_refused(given, "the given target of vertex 7 is not finite");
  given = result;
  given.landmark_fields->distances.conservativeResize(7, 80);
  expect_refused(given, "the given distances have 7 rows");
  given.landmark_fields = CP::Landmark_fields_3();
  expect_refused(given, "no column");
  given = result;
  given.landmark_fields->landmarks[4] = soup.points.size();
  expect_refused(given, "the given distances have landmark ");
  given.landmark_fields->landmarks[4] = 1;
  expect_refused(given, "landmark vertex 1 is not on the surface");
  given.landmark_fields->landmarks.pop_back();
  expect_refused(given, "the given distances have 79 landmarks");
  given = result;
  given.landmark_fields->distances(9, 2) = -1;
  expect_refused(given, "the given distances: the distance of vertex 9 to landmark");
}

} // namespace test_reuse_of_results
