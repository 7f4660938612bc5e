// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_components_of_the_call {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::bar;
using shapes::Polygon_soup;
using shapes::pose_of;
using shapes::Result;
using shapes::small_bar;

const Eigen::Index small_size = Eigen::Index(small_bar().points.size());

// The small bar first, 20 to the left of the other.
Polygon_soup two_bars() { return shapes::merged(small_bar(), bar(), 20.); }

CP::Options largest_component()
{
  CP::Options options;
  options.components = CP::Options::Components::LARGEST;
  return options;
}

// With the same lattice as in a separate call; by default, components share the cells.
CP::Options each_with_own_lattice()
{
  CP::Options options = shapes::each_component();
  options.lattice_spacing = .03;
  return options;
}

CP::Options with_lattice()
{
  CP::Options options;
  options.lattice_spacing = .03;
  return options;
}

Point_matrix pose_of_followers(const Polygon_soup& soup, const CP::Options& options,
                               Point_matrix& pose)
{
  const Result result = pose_of(soup, options);
  pose = result.pose;
  return result.pose_of_followers;
}

// The poses of the components are bitwise equal to those of separate calls.
TEST(Components, each_is_posed_as_if_alone)
{
  const Point_matrix pose = pose_of(two_bars(), each_with_own_lattice()).pose;
  EXPECT_EQ(pose.topRows(small_size), pose_of(small_bar(), with_lattice()).pose);
  const Polygon_soup moved_bar = shapes::merged({}, bar(), 20.);
  EXPECT_EQ(pose.bottomRows(pose.rows() - small_size), pose_of(moved_bar, with_lattice()).pose);
}

// The coordinates of a vertex in its cell are its row of the embedding: a follower at a vertex
// moves with it. This holds for each component, regardless of its size.
TEST(Components, followers_go_with_the_nearest)
{
  CP::Options options = shapes::each_component();
  options.followers = shapes::to_matrix(two_bars().points);
  Point_matrix pose;
  const Point_matrix followers = pose_of_followers(two_bars(), options, pose);
  EXPECT_LT((followers - pose).cwiseAbs().maxCoeff(), 1e-9);
}

// Isolated vertices are attached to the nearest component; a copy of a vertex moves with it.
TEST(Components, isolated_vertices_go_with_the_nearest)
{
  Polygon_soup soup = two_bars();
  for(const std::size_t v : {std::size_t(5), soup.points.size() - 4})
  {
    Polygon_soup with_copy = soup;
    with_copy.points.push_back(soup.points[v]);
    const Point_matrix pose = pose_of(with_copy, shapes::each_component()).pose;
    EXPECT_LT((pose.row(pose.rows() - 1) - pose.row(Eigen::Index(v))).norm(), 1e-9) << v;
  }
}

// The pose of the largest component is that of a separate call. The others, if not far away, move with
// the body, but keep their shape.
TEST(Components, the_largest_carries_followers_and_the_others)
{
  const Polygon_soup bars = shapes::merged(small_bar(), bar(), 2.6);
  const Polygon_soup moved_bar = shapes::merged({}, bar(), 2.6);
  CP::Options options = largest_component();
  options.followers = shapes::to_matrix(bars.points);
  Point_matrix pose;
  const Point_matrix followers = pose_of_followers(bars, options, pose);
  EXPECT_EQ(pose.bottomRows(pose.rows() - small_size), pose_of(moved_bar, CP::Options()).pose);
  const Eigen::Index n = pose.rows() - small_size;
  EXPECT_LT((followers - pose).bottomRows(n).cwiseAbs().maxCoeff(), 1e-9);
  const Point_matrix small = pose.topRows(small_size);
  EXPECT_LT(shapes::relative_rms(shapes::to_matrix(small_bar().points), small), 1e-12);
  EXPECT_LT((followers.topRows(small_size).colwise().mean() - small.colwise().mean()).norm(), 1e-9);
}

// Each of many components is bitwise equal to the result of a separate call.
TEST(Components, many)
{
  Polygon_soup soup;
  for(int i = 0; i < 12; ++i)
    soup = shapes::merged(soup, small_bar(), 8. * i);
  const Result all = pose_of(soup, each_with_own_lattice());
  EXPECT_TRUE(all.summary.converged());
  for(const int i : {0, 7, 11})
    EXPECT_EQ(all.pose.middleRows(i * small_size, small_size),
              pose_of(shapes::merged({}, small_bar(), 8. * i), with_lattice()).pose);
}

// Constraints that cannot hold are reported by elements of the input, never ignored.
TEST(Components, constraints_that_do_not_fit_are_refused)
{
  const auto expect_refused = [](const Polygon_soup& soup, CP::Options options,
                                 const CP::Spring_3& spring, const char* const text) {
    options.constraints.springs = {spring};
    EXPECT_THROW_WITH(pose_of(soup, options), std::invalid_argument, text);
  };
  const std::size_t of_large = two_bars().points.size() - 1;
  expect_refused(two_bars(), shapes::each_component(), {3, of_large, 1, 1},
                 "spring 0 names vertices 3 and");
  expect_refused(two_bars(), largest_component(), {3, of_large, 1, 1},
                 "spring 0 names vertex 3, which has no pose of its own");
  expect_refused(shapes::with_isolated_vertices(bar(), 2), CP::Options(), {1, 5, 1, 1},
                 "spring 0 names vertex 1, which has no pose of its own");

  const Polygon_soup soup = shapes::unsewn(bar());
  std::size_t twin = 1;
  while(soup.points[twin] != soup.points[0])
    ++twin;
  expect_refused(soup, CP::Options(), {0, twin, 1, 1}, "which are at the same position");
}

// A constraint within a component has the same effect as in a separate call.
TEST(Components, constraints_belong_to_their_component)
{
  CP::Options options = each_with_own_lattice();
  options.constraints.springs = {{2, 40, 1., 0.2}};
  const Point_matrix pose = pose_of(two_bars(), options).pose;
  EXPECT_EQ(pose.topRows(small_size), pose_of(small_bar(), options).pose);
  EXPECT_GT((pose - pose_of(two_bars(), each_with_own_lattice()).pose).norm(), 1e-3);
}

// The ends of a ring touch in a vertex: a constraint acts on both copies.
TEST(Components, constraints_act_on_all_copies)
{
  const Polygon_soup ring
    = shapes::to_polygons(shapes::boundary(shapes::tetrahedral_bent_bar(48, 6, 6, 6.)));
  const Point_matrix rest = shapes::to_matrix(ring.points);
  const auto vertex_at = [&](const std::array<double, 3>& p) {
    Eigen::Index nearest;
    (rest.rowwise() - Eigen::RowVector3d(p[0], p[1], p[2])).rowwise().norm().minCoeff(&nearest);
    return static_cast<std::size_t>(nearest);
  };
  const std::size_t p = vertex_at(shapes::bend({{0, 0, 1}}, 8, 6));
  const Polygon_soup soup = shapes::renamed(ring, vertex_at(shapes::bend({{8, 0, 1}}, 8, 6)), p);
  const Eigen::RowVector3d position = rest.row(Eigen::Index(p));
  CP::Options options;
  options.constraints.handles = {{p, position, 1e4}};
  EXPECT_LT((pose_of(soup, options).pose.row(Eigen::Index(p)) - position).norm(), .1);
}

// A vertex shared by components has only one pose, which is reported.
TEST(Components, common_vertices_are_named)
{
  const Polygon_soup soup = shapes::pinched_balls();
  const Result result = pose_of(soup, shapes::each_component());
  ASSERT_EQ(result.summary.warnings.size(), 2u);
  for(const std::string& warning : result.summary.warnings)
    EXPECT_NE(warning.find("vertex 8"), std::string::npos) << warning;
}

// A part of the surface whose weights are all 0 is reported by a vertex of the input.
TEST(Components, weights_of_a_component_must_not_all_be_zero)
{
  CP::Options options = shapes::each_component();
  options.matching_weights = Eigen::VectorXd::Ones(Eigen::Index(two_bars().points.size()));
  options.matching_weights.head(small_size).setZero();
  EXPECT_THROW_WITH(pose_of(two_bars(), options), std::invalid_argument,
                    "all matching weights are 0 in the part around vertex");
}

} // namespace test_components_of_the_call
