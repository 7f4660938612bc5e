// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"

#include <cstddef>
#include <stdexcept>

namespace test_changes_of_constraints {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;

int factorizations = 0;

struct Counting_factor_traits : CP::Default_factor_traits_d
{
  bool factor(const Matrix& matrix, NT& denominator)
  {
    ++factorizations;
    return CP::Default_factor_traits_d::factor(matrix, denominator);
  }
};

using Registrar
  = CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3, CGAL::Default, Counting_factor_traits>;

constexpr std::size_t n_bar = 41 * 16;

// A model of RegistrationConstraint_3 that may push instead of pulling: not semidefinite.
struct Push
{
  std::size_t matrix_revision() const { return revision; }
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    matrix.emplace_back(0, 0, entry);
  }
  void add_to_right_hand_side(const Point_matrix&, Point_matrix&) {}
  double energy(const Point_matrix&) const { return 0; }

  double entry = -1e6;
  std::size_t revision = 0;
};

// Adding, modifying and removing a few constraints: one factorization for all, and the same poses
// as those of new registrars.
TEST(Changes_of_constraints, poses_are_those_of_new_factorizations)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(40, 3, 3);
  const Eigen::VectorXd weights = uniform_weights(body.points());
  const Point_matrix target = Canonical_pose_test::bar_points(40, 3, 3, 2.);
  const CP::Registration_options options = Canonical_pose_test::to_the_end();
  CP::Spring_constraint_adaptor_3 springs(n_bar);
  CP::Handle_constraint_adaptor_3 handles(n_bar);
  Registrar kept(body, weights, 8., options);
  kept.set_target(target);
  factorizations = 0;
  kept.add_constraint(springs);
  kept.factor();
  bool has_handles = false;
  int steps = 0;
  const auto expect_same_pose = [&] {
    const int before = factorizations;
    Registrar fresh(body, weights, 8., options);
    fresh.set_target(target);
    fresh.add_constraint(springs);
    if(has_handles)
      fresh.add_constraint(handles);
    Point_matrix pose, expected;
    const CP::Registration_summary summary = kept.register_to_target(pose);
    EXPECT_EQ(factorizations, before) << steps;
    fresh.register_to_target(expected);
    EXPECT_LT((pose - expected).norm(), 1e-9 * expected.norm()) << steps;
    EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history)) << steps;
    ++steps;
  };
  springs.insert({0, 600, 1., 1.});
  expect_same_pose();
  handles.insert({40, {0, 9, 0}, 0.1});
  handles.insert({300, {3, 0, 3}, 1e6});
  kept.add_constraint(handles);
  has_handles = true;
  expect_same_pose();
  springs.set_stiffness(0, 0.01);
  springs.insert({17, 300, 1., 1.});
  expect_same_pose();
  springs.erase(0);
  handles.set_position(1, {3, 0, 4});
  expect_same_pose();
  kept.remove_constraint(handles);
  has_handles = false;
  expect_same_pose();
  springs.erase(0);
  expect_same_pose();
  EXPECT_EQ(steps, 6);
}

// Many constraints lead to a new factorization; they can then be removed one by one. A new detail
// length yields the same bytes as a new registrar, with constraints and after an update of the
// factor, and costs one factorization; a refused one changes nothing.
TEST(Changes_of_constraints, detail_length)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(40, 3, 3);
  const Eigen::VectorXd weights = uniform_weights(body.points());
  const Point_matrix target = Canonical_pose_test::bar_points(40, 3, 3, 2.);
  CP::Registration_options options;
  options.injective = false; // to untangle cells takes factorizations of its own
  CP::Spring_constraint_adaptor_3 springs(n_bar);
  springs.insert({0, n_bar - 1, 2., 0.5});
  Registrar kept(body, weights, 8., options);
  kept.set_target(target);
  Point_matrix before, after;
  kept.register_to_target(before);
  kept.add_constraint(springs);
  before.resize(0, 3);
  kept.register_to_target(before);
  EXPECT_THROW_WITH(kept.set_detail_length(0), std::invalid_argument, "detail_length");
  factorizations = 0;
  kept.register_to_target(after);
  EXPECT_EQ(factorizations, 0);
  EXPECT_EQ(after, before);

  options.detail_length = 0.03;
  Registrar fresh(body, weights, 8., options);
  fresh.set_target(target);
  fresh.add_constraint(springs);
  Point_matrix expected;
  fresh.register_to_target(expected);
  factorizations = 0;
  kept.set_detail_length(0.03);
  after.resize(0, 3);
  kept.register_to_target(after);
  EXPECT_EQ(factorizations, 1);
  EXPECT_EQ(after, expected);
  EXPECT_NE(after, before);
  EXPECT_EQ(kept.options().detail_length, 0.03);
}

TEST(Changes_of_constraints, many_constraints_are_factored)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(40, 3, 3);
  Registrar registrar(body, uniform_weights(body.points()), 8.);
  registrar.set_target(body.points());
  factorizations = 0;
  registrar.factor();
  CP::Handle_constraint_adaptor_3 handles(n_bar);
  for(std::size_t i = 0; i < n_bar; ++i)
    handles.insert({i, body.points().row(Eigen::Index(i)), 0.01});
  registrar.add_constraint(handles);
  registrar.factor();
  EXPECT_EQ(factorizations, 2);
  handles.erase(5);
  registrar.factor();
  EXPECT_EQ(factorizations, 2);
  EXPECT_THROW(registrar.remove_constraint(registrar), CGAL::Precondition_exception);
}

// A matrix that is not positive definite is refused with the same message, initially and later, and
// the registrar can still be used.
TEST(Changes_of_constraints, indefinite_constraints_are_refused)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(40, 3, 3);
  for(const bool is_factored_before : {false, true})
  {
    Registrar registrar(body, uniform_weights(body.points()), 8.);
    registrar.set_target(body.points());
    if(is_factored_before)
      registrar.factor();
    Push push;
    registrar.add_constraint(push);
    EXPECT_THROW_WITH(registrar.factor(), std::runtime_error,
                      "the matrix of the registration is not positive definite");
    push.entry = 0;
    ++push.revision;
    Point_matrix pose;
    EXPECT_TRUE(registrar.register_to_target(pose).converged());
    EXPECT_LT((pose - body.points()).norm(), 1e-6);
  }
}

} // namespace test_changes_of_constraints
