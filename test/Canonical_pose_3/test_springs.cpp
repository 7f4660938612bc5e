// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"

#include <cmath>
#include <limits>

namespace test_springs {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;

// Counts how often its matrix is read: once per factorization or update of the factor.
struct Counting_springs : CP::Spring_constraint_adaptor_3
{
  using CP::Spring_constraint_adaptor_3::Spring_constraint_adaptor_3;
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    ++factorizations;
    CP::Spring_constraint_adaptor_3::add_to_matrix(matrix);
  }
  mutable int factorizations = 0;
};

const std::size_t left = 13 + 39, right = left + 12; // centers of the two ends of the bar, 8 apart

// A spring pulls a single vertex far out of its cells: these remain inverted, so that the energy is
// minimal.
CP::Registration_options plain()
{
  CP::Registration_options options;
  options.injective = false;
  return options;
}

CP::Registration_options exact()
{
  CP::Registration_options options = plain();
  options.number_of_iterations = 2000;
  options.energy_tolerance = 1e-12;
  options.move_tolerance = 1e-9;
  return options;
}

// With its current length as rest length, a spring has no energy and must not move anything: the
// pose stays at rest.
TEST(Springs, relaxed_spring_does_nothing)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  ASSERT_NEAR((body.points().row(left) - body.points().row(right)).norm(), 8., 1e-12);
  Registrar registrar(body, uniform_weights(body.points()), 8.);
  CP::Spring_constraint_adaptor_3 springs(static_cast<std::size_t>(body.points().rows()));
  springs.insert({left, right, 8., 100.});
  registrar.add_constraint(springs);
  registrar.set_target(body.points());
  Point_matrix pose;
  EXPECT_TRUE(registrar.register_to_target(pose).converged());
  EXPECT_LT((pose - body.points()).norm(), 1e-9);
}

// Two separate tetrahedra with one target each move rigidly, without elastic energy. For targets at
// distance D, with weight m each, and a spring of rest length r between them, stationarity along
// the line yields the length x = (m D + kappa r) / (m + kappa).
TEST(Springs, length_in_equilibrium_is_exact)
{
  Point_matrix points(8, 3);
  points << 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 5, 0, 0, 6, 0, 0, 5, 1, 0, 5, 0, 1;
  const CP::Conforming_body_3 body(points, {{0, 1, 2, 3}, {4, 5, 6, 7}}, 8);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(8);
  weights[0] = weights[4] = 1;
  for(const double stiffness : {0.1, 1., 30.})
  {
    Registrar registrar(body, weights, 5., exact());
    CP::Spring_constraint_adaptor_3 springs(8);
    springs.insert({0, 4, 2., stiffness});
    registrar.add_constraint(springs);
    registrar.set_target(points);
    Point_matrix pose;
    const CP::Registration_summary summary = registrar.register_to_target(pose);
    EXPECT_TRUE(summary.converged());
    const double m = 0.5, expected = (m * 5 + stiffness * 2) / (m + stiffness);
    EXPECT_NEAR((pose.row(0) - pose.row(4)).norm(), expected, 1e-6);
    EXPECT_NEAR(summary.energy_constraints, stiffness / 2 * std::pow((expected - 2) / 5, 2), 1e-7);
    EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
  }
}

// The matrix depends on the pairs and their stiffness, not on the rest lengths.
TEST(Springs, rest_length_needs_no_factorization)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  Registrar registrar(body, uniform_weights(body.points()), 8., plain());
  Counting_springs springs(static_cast<std::size_t>(body.points().rows()));
  const std::size_t index = springs.insert({left, right, 8., 10.});
  registrar.add_constraint(springs);
  registrar.set_target(body.points());
  double previous = std::numeric_limits<double>::infinity();
  for(const double length : {7., 4., 1.})
  {
    springs.set_rest_length(index, length);
    Point_matrix pose;
    registrar.register_to_target(pose);
    const double distance = (pose.row(left) - pose.row(right)).norm();
    EXPECT_LT(distance, previous);
    EXPECT_GT(distance, length);
    previous = distance;
  }
  EXPECT_EQ(springs.factorizations, 1);
  springs.insert({0, 50, 1., 1.});
  Point_matrix pose;
  registrar.register_to_target(pose);
  EXPECT_EQ(springs.factorizations, 2);
}

// Ends that start at the same point have no direction; the spring must still push them apart,
// without NaN.
TEST(Springs, coinciding_ends)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  Registrar registrar(body, uniform_weights(body.points()), 8., plain());
  CP::Spring_constraint_adaptor_3 springs(static_cast<std::size_t>(body.points().rows()));
  springs.insert({left, right, 2., 10.});
  registrar.add_constraint(springs);
  Point_matrix target = body.points();
  target.row(left) = target.row(right);
  registrar.set_target(target);
  Point_matrix pose;
  const CP::Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_TRUE(pose.allFinite());
  EXPECT_GT((pose.row(left) - pose.row(right)).norm(), 1.);
  EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
}

TEST(Springs, bad_springs_are_named)
{
  CP::Spring_constraint_adaptor_3 springs(10);
  springs.insert({1, 2, 0., 1.});
  EXPECT_THROW_WITH(springs.insert({3, 3, 1., 1.}), std::invalid_argument,
                    "spring 1 joins vertex 3 to itself");
  EXPECT_THROW_WITH(springs.insert({3, 10, 1., 1.}), std::invalid_argument,
                    "names vertex 10, but there are 10");
  EXPECT_THROW_WITH(springs.insert({3, 4, -1., 1.}), std::invalid_argument, "rest length");
  EXPECT_THROW_WITH(springs.insert({3, 4, 1., 0.}), std::invalid_argument, "stiffness");
  EXPECT_THROW_WITH(springs.set_rest_length(0, std::nan("")), std::invalid_argument, "rest length");
  EXPECT_THROW(springs.set_rest_length(1, 1.), CGAL::Precondition_exception);
  EXPECT_EQ(springs.elements().size(), 1u);
}

} // namespace test_springs
