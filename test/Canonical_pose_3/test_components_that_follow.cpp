// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/canonical_pose_3.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_components_that_follow {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::pose_of;
using shapes::Result;
using shapes::Triangle_soup;
using Followers = std::vector<CP::Registration_summary::Follower>;

// The bar is 8 long and 1 thick.
const std::size_t bar_size = shapes::bent_bar().points.size();

void append(Triangle_soup& soup, const Triangle_soup& other)
{
  const std::size_t n = soup.points.size();
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for(const auto& t : other.triangles)
    soup.triangles.push_back({{t[0] + n, t[1] + n, t[2] + n}});
}

// A box, bent with the bar.
Triangle_soup box(const std::array<double, 3>& low, const std::array<double, 3>& lengths,
                  const std::size_t segments)
{
  Triangle_soup soup = shapes::boundary(shapes::tetrahedral_box(segments, 3, 3, lengths));
  for(auto& p : soup.points)
    p = shapes::bend({{p[0] + low[0], p[1] + low[1], p[2] + low[2]}}, 8, 2);
  return soup;
}

Triangle_soup tetrahedron(const std::array<double, 3>& at, const double size)
{
  Triangle_soup soup;
  soup.points.push_back(at);
  for(std::size_t k = 0; k < 3; ++k)
  {
    soup.points.push_back(at);
    soup.points.back()[k] += size;
  }
  soup.triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}};
  return soup;
}

Triangle_soup bar_and(const Triangle_soup& other)
{
  Triangle_soup soup = shapes::bent_bar();
  append(soup, other);
  return soup;
}

// Who follows whom does not depend on the pose.
CP::Options quick()
{
  CP::Options options;
  options.number_of_rounds = 0;
  options.registration.number_of_iterations = 1;
  return options;
}

Followers followers_of(const Triangle_soup& soup, const CP::Options& options = quick())
{
  return pose_of(soup, options).summary.followers;
}

void expect_one_follower(const Triangle_soup& other, const bool is_rigid)
{
  const Followers followers = followers_of(bar_and(other));
  ASSERT_EQ(followers.size(), 1u);
  EXPECT_EQ(followers[0].component, 1u);
  EXPECT_EQ(followers[0].vertex, bar_size);
  EXPECT_EQ(followers[0].leader, 0u);
  EXPECT_EQ(followers[0].is_rigid, is_rigid);
}

void expect_refused(const Triangle_soup& soup, const char* const text)
{
  EXPECT_THROW_WITH(pose_of(soup, quick()), std::invalid_argument, text);
}

Triangle_soup ball(const std::array<double, 3>& center, const double radius,
                   const unsigned int subdivisions)
{
  Triangle_soup soup = shapes::icosphere_soup(subdivisions, radius);
  for(auto& p : soup.points)
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += center[k];
  return soup;
}

// On its end.
Triangle_soup upright_bar()
{
  Triangle_soup soup = shapes::bent_bar();
  for(auto& p : soup.points)
    std::swap(p[0], p[2]);
  return soup;
}

// A point of the bar: x along it, from 0 to 8, y and z across it, from 0 to 1.
std::array<double, 3> at(const double x, const double y, const double z)
{
  return shapes::bend({{x, y, z}}, 8, 2);
}

// Triangles with random corners in cubes, which are at random places in a larger one.
Triangle_soup random_triangles(const std::size_t number, const double extent, const double size)
{
  std::mt19937 generator(1);
  const auto random = [&] { return double(generator()) / double(std::mt19937::max()); };
  Triangle_soup soup;
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::array<double, 3> low{{random(), random(), random()}};
    for(std::size_t k = 0; k < 3; ++k)
    {
      soup.points.emplace_back();
      for(std::size_t j = 0; j < 3; ++j)
        soup.points.back()[j] = (extent - size) * low[j] + size * random();
    }
    soup.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
  }
  return soup;
}

Triangle_soup crumbs(const std::size_t number)
{
  Triangle_soup soup;
  for(std::size_t i = 0; i < number; ++i)
    append(soup, tetrahedron(shapes::bend({{8 * double(i) / double(number), 1.5, .5}}, 8, 2), .02));
  return soup;
}

Triangle_soup tetrahedra_in_a_row(const std::size_t number)
{
  Triangle_soup soup;
  for(std::size_t i = 0; i < number; ++i)
    append(soup, tetrahedron({{2. * double(i), 0, 0}}, 1));
  return soup;
}

TEST(Components_that_follow, small_ones)
{
  expect_one_follower(tetrahedron({{0, 1.5, 0}}, .5), true);
}

// The rotation of the end of the bar would carry it away.
TEST(Components_that_follow, those_far_away_keep_their_place)
{
  const Triangle_soup soup = bar_and(tetrahedron({{0, 9, 0}}, .5));
  for(const auto mode : {CP::Options::Components::AUTOMATIC, CP::Options::Components::EACH})
  {
    CP::Options options;
    options.components = mode;
    const Result result = pose_of(soup, options);
    EXPECT_EQ(result.pose.bottomRows(4), shapes::to_matrix(soup.points).bottomRows(4));
    ASSERT_EQ(result.summary.followers.size(), 1u);
    EXPECT_EQ(result.summary.followers[0].leader, 1u);
  }
}

// A fifth of the area of the bar.
TEST(Components_that_follow, limbs_that_touch)
{
  expect_one_follower(box({{7.9, .2, .2}}, {{3, .6, .6}}, 9), true);
  EXPECT_THROW_WITH(pose_of(bar_and(box({{9.5, .2, .2}}, {{3, .6, .6}}, 9)), quick()),
                    std::invalid_argument, "the surface has 2 connected components");
}

TEST(Components_that_follow, sleeves)
{
  expect_one_follower(box({{2, -.1, -.1}}, {{4, 1.2, 1.2}}, 12), false);
}

TEST(Components_that_follow, what_is_inside)
{
  expect_one_follower(box({{1, .3, .3}}, {{6, .4, .4}}, 18), false);
}

// A dress stands off from the body that it wraps, and has a larger area: the body leads.
TEST(Components_that_follow, what_is_around)
{
  Triangle_soup dress = box({{2, -1, -1}}, {{4, 3, 3}}, 12);
  const Triangle_soup straight = shapes::boundary(shapes::tetrahedral_box(12, 3, 3, {{4, 3, 3}}));
  const auto is_end = [&](const std::array<std::size_t, 3>& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](const std::size_t v) { return straight.points[v][0] == 0; })
           || std::all_of(t.begin(), t.end(),
                          [&](const std::size_t v) { return straight.points[v][0] == 4; });
  };
  dress.triangles.erase(std::remove_if(dress.triangles.begin(), dress.triangles.end(), is_end),
                        dress.triangles.end());
  const Result result = pose_of(bar_and(dress), quick());
  ASSERT_EQ(result.summary.followers.size(), 1u);
  EXPECT_EQ(result.summary.followers[0].component, 0u);
  EXPECT_EQ(result.summary.followers[0].leader, 1u);
  EXPECT_FALSE(result.summary.followers[0].is_rigid);
  EXPECT_EQ(result.pose.topRows(Eigen::Index(bar_size)), pose_of(shapes::bent_bar(), quick()).pose);
}

// The handle of a sword touches the bar, and the blade the handle: the sword stays in one piece.
TEST(Components_that_follow, things_of_several_pieces)
{
  Triangle_soup soup = bar_and(box({{7.5, .45, .45}}, {{1.5, .1, .1}}, 3));
  append(soup, box({{9, .45, .45}}, {{3, .1, .1}}, 6));
  const Result result = pose_of(soup, CP::Options());
  EXPECT_EQ(result.summary.followers.size(), 2u);
  const Eigen::Index n = result.pose.rows() - Eigen::Index(bar_size);
  EXPECT_LT(
    shapes::relative_rms(shapes::to_matrix(soup.points).bottomRows(n), result.pose.bottomRows(n)),
    1e-9);
}

// Two shapes are refused, even if they touch; others may follow them.
TEST(Components_that_follow, several_shapes_are_refused)
{
  Triangle_soup soup = bar_and(box({{7.8, 0, 0}}, {{8, 1, 1}}, 24));
  EXPECT_THROW_WITH(pose_of(soup, quick()), std::invalid_argument,
                    "the surface has 2 connected components");
  append(soup, crumbs(3));
  EXPECT_THROW_WITH(pose_of(soup, quick()), std::invalid_argument,
                    "2 connected components, besides 3 that follow them: vertex 0 belongs to one, "
                    "vertex ");
  soup = bar_and(box({{7.8, 0, 0}}, {{8, 1, 1}}, 24));
  append(soup, crumbs(1));
  EXPECT_THROW_WITH(pose_of(soup, quick()), std::invalid_argument,
                    "2 connected components, besides 1 that follows them: vertex 0 belongs to one");
  CP::Options options = quick();
  options.components = CP::Options::Components::REFUSE;
  EXPECT_THROW_WITH(pose_of(bar_and(crumbs(1)), options), std::invalid_argument,
                    "the surface has 2 connected components");
}

// A bar does not follow the dome of a sky, whether it floats there or stands on its floor.
TEST(Components_that_follow, a_figure_under_a_dome_is_a_shape)
{
  for(const unsigned int subdivisions : {1u, 3u})
    for(const double radius : {5., 7., 15., 60.})
      expect_refused(bar_and(ball(at(4, .5, .5), radius, subdivisions)),
                     "the surface has 2 connected components");
  expect_refused(bar_and(ball(at(4, .5, .5), 100, 4)), "the surface has 2 connected components");
  Triangle_soup room = shapes::boundary(shapes::tetrahedral_box(2, 2, 2, {{30, 30, 15}}));
  for(auto& p : room.points)
    p = {{p[0] - 15, p[1] - 15, p[2]}};
  append(room, upright_bar());
  expect_refused(room, "the surface has 2 connected components");
  Triangle_soup scene = bar_and(ball(at(4, .5, .5), 15, 3));
  append(scene, box({{2, -.1, -.1}}, {{4, 1.2, 1.2}}, 12)); // a sleeve
  append(scene, crumbs(3));
  expect_refused(scene, "connected components, besides 3 that follow them");
}

TEST(Components_that_follow, a_figure_on_the_ground_is_a_shape)
{
  for(const std::size_t number : {1u, 60u})
  {
    Triangle_soup ground = shapes::plane_grid_soup(number, number, 40, 40);
    for(auto& p : ground.points)
      p = {{p[0] - 20, p[1] - 20, 0}};
    append(ground, upright_bar());
    expect_refused(ground, "the surface has 2 connected components");
  }
}

// In a room, on a plinth: the figure has most of the detail.
TEST(Components_that_follow, a_figure_beside_something_simple_is_a_shape)
{
  const Triangle_soup figure = upright_bar();
  std::array<double, 3> low = figure.points[0], high = low;
  for(const auto& p : figure.points)
    for(std::size_t k = 0; k < 3; ++k)
    {
      low[k] = (std::min)(low[k], p[k]);
      high[k] = (std::max)(high[k], p[k]);
    }
  const auto expect_apart
    = [&](const std::array<double, 3>& from, const std::array<double, 3>& to) {
        Triangle_soup scene = shapes::boundary(
          shapes::tetrahedral_box(1, 1, 1, {{to[0] - from[0], to[1] - from[1], to[2] - from[2]}}));
        for(auto& p : scene.points)
          for(std::size_t k = 0; k < 3; ++k)
            p[k] += from[k];
        append(scene, figure);
        expect_refused(scene, "the surface has 2 connected components");
      };
  for(const double gap : {.8, 2., 8.})
    expect_apart({{low[0] - gap, low[1] - gap, low[2] - gap}},
                 {{high[0] + gap, high[1] + gap, high[2] + gap}});
  for(const double gap : {2., 4., 8.})
    expect_apart({{low[0] - gap, low[1] - gap, low[2] - .4}},
                 {{high[0] + gap, high[1] + gap, low[2] - .01}});
}

// Eyes that are half outside or below the skin, an organ, marbles, a ring, a pin, a hat.
TEST(Components_that_follow, what_belongs_to_a_body)
{
  for(const double depth : {.0, .15, .25})
    for(const unsigned int subdivisions : {1u, 3u})
      expect_one_follower(ball(at(7.5, 1 - depth, .5), .2, subdivisions), true);
  expect_one_follower(ball(at(4, .5, .5), .3, 2), true);
  Triangle_soup marbles = shapes::bent_bar();
  for(int i = 0; i < 30; ++i)
    append(marbles, ball(at(.5 + .2 * i, .5, .5), .02, 1));
  EXPECT_EQ(followers_of(marbles).size(), 30u);
  Triangle_soup ring = shapes::torus_soup(24, 8, .9, .1);
  for(auto& p : ring.points)
    p = at(4 + p[2], p[0] + .5, p[1] + .5);
  expect_one_follower(ring, true);
  expect_one_follower(box({{4, .45, -1}}, {{.1, .1, 3}}, 1), true);
  expect_one_follower(ball(at(7.9, .5, .5), .8, 2), true); // a helmet
}

// None of many large triangles is the main one. Small ones follow.
TEST(Components_that_follow, triangles_at_random)
{
  for(const std::size_t number : {5u, 20u, 100u, 1000u})
    expect_refused(random_triangles(number, 1, 1), "connected components");
  EXPECT_EQ(followers_of(bar_and(random_triangles(200, 2, .1))).size(), 200u);
}

// What is far away keeps its place, whichever component is posed; what is connected by a vertex
// follows, even if several components are refused.
TEST(Components_that_follow, are_named)
{
  CP::Options options = quick();
  options.components = CP::Options::Components::LARGEST;
  const Triangle_soup soup = bar_and(ball({{0, 12, 0}}, .8, 2));
  Result result = pose_of(soup, options);
  const Eigen::Index n = result.pose.rows() - Eigen::Index(bar_size);
  EXPECT_EQ(result.pose.bottomRows(n), shapes::to_matrix(soup.points).bottomRows(n));
  ASSERT_EQ(result.summary.followers.size(), 1u);
  EXPECT_EQ(result.summary.followers[0].leader, 1u);

  Triangle_soup pinched = bar_and(tetrahedron(shapes::bent_bar().points[0], -.2));
  for(auto& t : pinched.triangles)
    std::replace(t.begin(), t.end(), bar_size, std::size_t(0));
  for(const auto mode : {CP::Options::Components::AUTOMATIC, CP::Options::Components::REFUSE,
                         CP::Options::Components::LARGEST, CP::Options::Components::EACH})
  {
    options.components = mode;
    result = pose_of(pinched, options);
    ASSERT_EQ(result.summary.followers.size(), 1u);
    EXPECT_EQ(result.summary.followers[0].component, 1u);
    EXPECT_EQ(result.summary.followers[0].leader, 0u);
  }
}

// What touches a follower follows, too.
TEST(Components_that_follow, a_chain)
{
  Triangle_soup soup = bar_and(box({{7.9, .2, .2}}, {{3, .6, .6}}, 9));
  append(soup, box({{10.8, .2, .2}}, {{2.5, .6, .6}}, 9));
  EXPECT_EQ(followers_of(soup).size(), 2u);
}

// Whether something follows has no effect on what it follows. A sleeve is as thick as before, and a
// crumb keeps its shape and its distance from the bar.
TEST(Components_that_follow, move_with_the_body)
{
  const Point_matrix alone = pose_of(shapes::bent_bar(), CP::Options()).pose;
  Triangle_soup soup = bar_and(box({{2, -.1, -.1}}, {{4, 1.2, 1.2}}, 12));
  append(soup, tetrahedron(shapes::bend({{8, 1.05, .5}}, 8, 2), .1));
  const Point_matrix rest = shapes::to_matrix(soup.points);
  const Point_matrix pose = pose_of(soup, CP::Options()).pose;
  const auto n = static_cast<Eigen::Index>(bar_size);
  EXPECT_EQ(pose.topRows(n), alone);
  for(Eigen::Index i = n; i < rest.rows(); ++i)
  {
    Eigen::Index nearest;
    const double at_rest
      = (rest.topRows(n).rowwise() - rest.row(i)).rowwise().norm().minCoeff(&nearest);
    EXPECT_NEAR((pose.row(i) - pose.row(nearest)).norm(), at_rest, .3) << i;
  }
  EXPECT_LT(shapes::relative_rms(rest.bottomRows(4), pose.bottomRows(4)), 1e-12);
  EXPECT_GT(shapes::relative_rms(rest.middleRows(n, rest.rows() - n - 4),
                                 pose.middleRows(n, rest.rows() - n - 4)),
            1e-2);
}

// Crumbs cost no cells. Without rounds of their own, all of them keep their edges.
TEST(Components_that_follow, crumbs_have_no_body)
{
  CP::Options options = quick();
  const std::size_t cells = pose_of(shapes::bent_bar(), options).summary.body.tetrahedra;
  options.components = CP::Options::Components::EACH;
  const Triangle_soup soup = bar_and(crumbs(100));
  const Result result = pose_of(soup, options);
  EXPECT_EQ(result.summary.body.tetrahedra, cells);
  ASSERT_EQ(result.summary.followers.size(), 100u);
  const Point_matrix rest = shapes::to_matrix(soup.points);
  for(const auto& follower : result.summary.followers)
  {
    EXPECT_EQ(follower.leader, 0u);
    const auto first = static_cast<Eigen::Index>(follower.vertex);
    EXPECT_LT(shapes::relative_rms(rest.middleRows(first, 4), result.pose.middleRows(first, 4)),
              1e-9);
  }
}

// None is small against the others: what has no body keeps its place.
TEST(Components_that_follow, equal_ones_keep_their_place)
{
  CP::Options options = quick();
  options.components = CP::Options::Components::EACH;
  const Triangle_soup soup = tetrahedra_in_a_row(60);
  const Result result = pose_of(soup, options);
  ASSERT_EQ(result.summary.followers.size(), 59u);
  for(const auto& follower : result.summary.followers)
  {
    EXPECT_EQ(follower.leader, follower.component);
    const auto first = static_cast<Eigen::Index>(follower.vertex);
    EXPECT_EQ(result.pose.middleRows(first, 4),
              shapes::to_matrix(soup.points).middleRows(first, 4));
  }
}

// Ten bodies have about as many cells as one.
TEST(Components_that_follow, bodies_share_their_cells)
{
  CP::Options options = quick();
  options.components = CP::Options::Components::EACH;
  Triangle_soup soup;
  for(int i = 0; i < 10; ++i)
    append(soup, shapes::tube_soup(16, 12, 4 + .01 * i, .5));
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    soup.points[i][1] += 3 * double(i / (soup.points.size() / 10));
  const Result all = pose_of(soup, options);
  EXPECT_TRUE(all.summary.followers.empty());
  EXPECT_LT(all.summary.body.tetrahedra, 36000u);
  EXPECT_GT(all.summary.body.tetrahedra, 6000u);
  // The same warning once.
  EXPECT_EQ(std::count(all.summary.warnings.begin(), all.summary.warnings.end(),
                       all.summary.warnings.front()),
            1);
}

// A visitor observes one component after the other; without one, they are posed in parallel.
TEST(Components_that_follow, the_order_has_no_effect)
{
  CP::Options options = shapes::each_component();
  options.number_of_rounds = 1;
  const Triangle_soup soup = bar_and(tetrahedra_in_a_row(5));
  Triangle_soup moved = soup;
  for(std::size_t i = bar_size; i < moved.points.size(); ++i)
    moved.points[i][1] += 9;
  const Point_matrix in_parallel = pose_of(moved, options).pose;
  int last = 0, first_iterations = 0;
  options.visitor = [&](const CP::Registration_progress& progress) {
    first_iterations += progress.iteration == 1 && last != 1 ? 1 : 0;
    last = progress.iteration;
    return true;
  };
  EXPECT_EQ(pose_of(moved, options).pose, in_parallel);
  EXPECT_GE(first_iterations, 6);
}

// A needle whose height is a rounding error cannot be posed: it follows, instead of ending the call.
TEST(Components_that_follow, pieces_without_area)
{
  for(const double height : {0., 1e-14, 1e-11})
    for(const auto mode : {CP::Options::Components::AUTOMATIC, CP::Options::Components::REFUSE,
                           CP::Options::Components::LARGEST, CP::Options::Components::EACH})
    {
      Triangle_soup needle;
      needle.points = {{{20, 0, 0}}, {{24, 0, 0}}, {{22, height, 0}}};
      needle.triangles = {{{0, 1, 2}}};
      CP::Options options = quick();
      options.components = mode;
      const Triangle_soup soup = bar_and(needle);
      const Result result = pose_of(soup, options);
      EXPECT_TRUE(result.is_usable());
      EXPECT_TRUE(result.pose.allFinite());
      EXPECT_EQ(result.summary.followers.size(), 1u);
      EXPECT_THROW_WITH(pose_of(needle, options), std::invalid_argument,
                        "the surface has no area: all its faces are degenerate");
    }
}

TEST(Components_that_follow, pieces_without_area_beside_small_ones)
{
  Triangle_soup needle;
  needle.points = {{{20, 0, 0}}, {{24, 0, 0}}, {{22, 0, 0}}};
  needle.triangles = {{{0, 1, 2}}};
  Triangle_soup soup = bar_and(needle);
  append(soup, tetrahedron({4, 4, 0}, .1));
  const Result result = pose_of(soup, quick());
  EXPECT_TRUE(result.pose.allFinite());
  EXPECT_EQ(result.summary.followers.size(), 2u);
}

} // namespace test_components_that_follow
