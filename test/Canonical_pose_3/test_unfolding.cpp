// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The registrar without a target. The energy, its gradient by finite differences, the growth of a
// thin bar, and what does not change under motions and scaling are known exactly.

#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Unfolding.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test_unfolding {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::bar_body;
using Canonical_pose_test::never_rises;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::to_the_end;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using CP::Registration_options;
using CP::Registration_summary;
using CP::Unfolding;

constexpr double LENGTH = 8;

Unfolding with_weight(const double weight)
{
  Unfolding unfolding;
  unfolding.weight = weight;
  return unfolding;
}

Point_matrix unfolded(const CP::Conforming_body_3& body, const double weight,
                      const double length_scale = LENGTH,
                      const Registration_options& options = to_the_end())
{
  Registrar registrar(body, uniform_weights(body.points()), length_scale, options);
  registrar.set_unfolding(with_weight(weight));
  Point_matrix pose;
  EXPECT_TRUE(registrar.register_to_target(pose).converged());
  return pose;
}

// The mean distance to the centroid; all weights are equal.
double mean_distance(const Point_matrix& points)
{
  return (points.rowwise() - points.colwise().mean()).rowwise().norm().mean();
}

// The first term of the energy is the mean distance to the centroid, which is computed again here;
// the energy is the sum of the terms. At the rest pose, where the iteration starts, the second term
// is 0.
TEST(Unfolding, energy_is_that_of_the_formula)
{
  const CP::Conforming_body_3 body = bar_body(12, 2, 2, 2.);
  Registrar registrar(body, uniform_weights(body.points()), LENGTH);
  registrar.set_unfolding(with_weight(0.02));
  Point_matrix pose;
  const Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_NEAR(summary.energy_history.front(), -0.02 * mean_distance(body.points()) / LENGTH, 1e-15);
  EXPECT_NEAR(summary.energy_match, -0.02 * mean_distance(pose) / LENGTH, 1e-15);
  EXPECT_NEAR(summary.energy, summary.energy_match + summary.energy_arap, 1e-15);
  EXPECT_GT(summary.energy_arap, 0);
}

// Each step minimizes an upper bound of the energy, whether the weight is small or large.
TEST(Unfolding, energy_never_rises)
{
  const CP::Conforming_body_3 body = bar_body(12, 2, 2, 4.);
  for(const double weight : {1e-4, 0.01, 1.})
    for(const int window : {0, 5})
    {
      Registration_options options;
      options.acceleration_window = window;
      Registrar registrar(body, uniform_weights(body.points()), LENGTH, options);
      registrar.set_unfolding(with_weight(weight));
      Point_matrix pose;
      const Registration_summary summary = registrar.register_to_target(pose);
      std::vector<double> growth; // of the negative energy
      for(const double e : summary.energy_history)
        growth.push_back(e - summary.energy_history.back());
      EXPECT_TRUE(never_rises(growth)) << weight << ' ' << window;
      EXPECT_LT(summary.energy, summary.energy_history.front());
    }
}

// The iteration ends where the gradient of the energy is 0. Central differences of the energy, which
// the registrar evaluates at any position, have an error of about 1e-9 here; at the rest pose, they
// are a thousand times as large as at the end.
TEST(Unfolding, gradient_vanishes_at_the_end)
{
  const CP::Conforming_body_3 body = bar_body(6, 1, 1, 1.);
  Registrar registrar(body, uniform_weights(body.points()), LENGTH, to_the_end());
  registrar.set_unfolding(with_weight(0.02));
  Point_matrix pose;
  ASSERT_TRUE(registrar.register_to_target(pose).converged());
  registrar.set_number_of_iterations(0);
  const auto largest_slope = [&](const Point_matrix& position) {
    const double h = 1e-5;
    double largest = 0;
    for(Eigen::Index i = 0; i < position.size(); ++i)
    {
      double energies[2];
      for(const int side : {0, 1})
      {
        Point_matrix moved = position;
        moved.data()[i] += side == 0 ? -h : h;
        energies[side] = registrar.register_to_target(moved).energy;
      }
      largest = (std::max)(largest, std::abs(energies[1] - energies[0]) / (2 * h));
    }
    return largest;
  };
  EXPECT_LT(largest_slope(pose), 1e-8);
  EXPECT_GT(largest_slope(body.points()), 1e-5);
}

// A body in equilibrium stays where it is.
TEST(Unfolding, equilibrium_is_kept)
{
  const CP::Conforming_body_3 body = bar_body(12, 2, 2, 1.);
  Registrar registrar(body, uniform_weights(body.points()), LENGTH, to_the_end());
  registrar.set_unfolding(with_weight(0.01));
  Point_matrix pose;
  ASSERT_TRUE(registrar.register_to_target(pose).converged());
  Point_matrix again = pose;
  EXPECT_LE(registrar.register_to_target(again).iterations, 3);
  EXPECT_LT((again - pose).cwiseAbs().maxCoeff(), 1e-7 * LENGTH);
}

// The force on the part of a thin bar of length L beyond s, by its end at L/2, is the share of the
// mass there, (L/2 - s) / L; it stretches the bar at s by mu / (2 l^2) times this. The integral is mu
// / (8 l^2). The bar is 40 times as long as thick; the vertices at its ends have the weight of all
// others, whereas their share of the length is half as large, an error of first order in 1/n.
TEST(Unfolding, thin_bar_grows_as_predicted)
{
  const auto growth = [](const std::size_t n, const double weight) {
    const CP::Conforming_body_3 body = Canonical_pose_test::to_body(
      Canonical_pose_test::tetrahedral_bent_bar(n, 1, 1, 0., {{LENGTH, 0.2, 0.2}}));
    const Point_matrix pose = unfolded(body, weight);
    return (pose.col(0).maxCoeff() - pose.col(0).minCoeff()) / LENGTH - 1;
  };
  for(const double weight : {0.001, 0.01, 0.1})
  {
    const double predicted = weight / (8 * 0.1 * 0.1);
    EXPECT_NEAR(growth(40, weight), predicted, 0.06 * predicted);
    EXPECT_NEAR(growth(80, weight), predicted, 0.03 * predicted);
  }
}

// The ends of a bent bar move apart, and its pose approaches that of the straight bar, the more so the
// larger the weight.
TEST(Unfolding, bent_bar_becomes_straight)
{
  const auto pose = [](const double angle, const double weight) {
    Registration_options options = to_the_end();
    options.energy_tolerance = 1e-10;
    options.move_tolerance = 1e-6;
    return unfolded(bar_body(24, 2, 2, angle), weight, LENGTH, options);
  };
  const double before = Canonical_pose_test::relative_rms(bar_body(24, 2, 2, 2.).points(),
                                                          bar_body(24, 2, 2, 0.).points());
  const double weak = Canonical_pose_test::relative_rms(pose(2., 0.02), pose(0., 0.02));
  const double strong = Canonical_pose_test::relative_rms(pose(2., 0.08), pose(0., 0.08));
  EXPECT_LT(weak, 0.5 * before);
  EXPECT_LT(strong, 0.2 * before);
}

// Lengths are relative to L, and the iteration starts at the rest pose, so the pose follows motions and
// scaling up to rounding. The centroid remains where it was.
TEST(Unfolding, pose_follows_motions_and_scaling)
{
  const Canonical_pose_test::Tetrahedral_soup soup
    = Canonical_pose_test::tetrahedral_bent_bar(12, 2, 2, 2.);
  const CP::Conforming_body_3 body = Canonical_pose_test::to_body(soup);
  const Point_matrix pose = unfolded(body, 0.01);
  EXPECT_LT((pose.colwise().mean() - body.points().colwise().mean()).norm(), 1e-7 * LENGTH);

  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2., Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const auto moved = [&](const Point_matrix& points) {
    return Point_matrix((300 * points * rotation.transpose()).rowwise()
                        + Eigen::RowVector3d(3, 2, 1));
  };
  const CP::Conforming_body_3 moved_body(moved(body.points()), body.cells(),
                                         static_cast<std::size_t>(body.points().rows()));
  EXPECT_LT((unfolded(moved_body, 0.01, 300 * LENGTH) - moved(pose)).cwiseAbs().maxCoeff(),
            1e-6 * 300 * LENGTH);
}

// Without constraints, all terms but one scale with the square of the detail length.
TEST(Unfolding, only_the_ratio_to_the_detail_length_matters)
{
  const CP::Conforming_body_3 body = bar_body(12, 2, 2, 2.);
  Registration_options options = to_the_end();
  const Point_matrix pose = unfolded(body, 0.01, LENGTH, options);
  options.detail_length *= 2;
  EXPECT_LT((unfolded(body, 0.04, LENGTH, options) - pose).cwiseAbs().maxCoeff(), 1e-6 * LENGTH);
}

// The matrix changes with the mode, in both directions.
TEST(Unfolding, target_replaces_unfolding)
{
  const CP::Conforming_body_3 body = bar_body(12, 2, 2);
  const Point_matrix target = Canonical_pose_test::bar_points(12, 2, 2, 1.);
  Registrar registrar(body, uniform_weights(body.points()), LENGTH);
  registrar.set_target(target);
  Point_matrix pose, pose_after, unfolded_before, unfolded_after;
  registrar.register_to_target(pose);
  registrar.set_unfolding(Unfolding());
  registrar.register_to_target(unfolded_before);
  registrar.set_target(target);
  registrar.register_to_target(pose_after);
  registrar.set_unfolding(Unfolding());
  registrar.register_to_target(unfolded_after);
  EXPECT_EQ(pose_after, pose);
  EXPECT_EQ(unfolded_after, unfolded_before);
}

// A handle pulls the centroid along; the pose is otherwise the same, since the energy does not depend on
// translations.
TEST(Unfolding, handle_fixes_the_position)
{
  const CP::Conforming_body_3 body = bar_body(12, 2, 2, 2.);
  const Point_matrix free = unfolded(body, 0.01);
  Registrar registrar(body, uniform_weights(body.points()), LENGTH, to_the_end());
  registrar.set_unfolding(with_weight(0.01));
  CP::Handle_constraint_adaptor_3 handles(static_cast<std::size_t>(body.points().rows()));
  handles.insert({5, {1, 2, 3}, 1.});
  registrar.add_constraint(handles);
  Point_matrix pose;
  ASSERT_TRUE(registrar.register_to_target(pose).converged());
  EXPECT_LT((pose.row(5) - Eigen::RowVector3d(1, 2, 3)).norm(), 1e-4);
  EXPECT_LT(Canonical_pose_test::relative_rms(pose, free), 1e-4);
}

// Parts without a connection would move apart without end.
TEST(Unfolding, refuses_what_has_no_minimum)
{
  Canonical_pose_test::Tetrahedral_soup soup
    = Canonical_pose_test::tetrahedral_bent_bar(2, 1, 1, 0.);
  const CP::Conforming_body_3 body = Canonical_pose_test::to_body(soup);
  const std::size_t n = soup.points.size(), m = soup.cells.size();
  for(std::size_t i = 0; i < n; ++i)
    soup.points.push_back({soup.points[i][0] + 20, soup.points[i][1], soup.points[i][2]});
  for(std::size_t t = 0; t < m; ++t)
  {
    auto cell = soup.cells[t];
    for(std::size_t& v : cell)
      v += n;
    soup.cells.push_back(cell);
  }
  const CP::Conforming_body_3 two_bodies = Canonical_pose_test::to_body(soup);
  Registrar of_two(two_bodies, uniform_weights(two_bodies.points()), LENGTH);
  EXPECT_THROW_WITH(of_two.set_unfolding(Unfolding()), std::invalid_argument, "not connected");

  Registrar registrar(body, uniform_weights(body.points()), LENGTH);
  for(const double weight :
      {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW_WITH(registrar.set_unfolding(with_weight(weight)), std::invalid_argument,
                      "option unfolding.weight is");
}

} // namespace test_unfolding
