// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "constraint_samples.h"
#include "matchers.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace test_constraint_lists {

using namespace Canonical_pose_test;

constexpr int n = number_of_points;

// A modified list is equal to one constructed with the same elements.
TEST(Constraints, changes_and_removals)
{
  CP::Spring_constraint_adaptor_3 changed = springs();
  const std::size_t revision = changed.matrix_revision();
  changed.set_rest_length(0, 5.);
  EXPECT_EQ(changed.matrix_revision(), revision);
  changed.set_stiffness(0, 0.3);
  EXPECT_NE(changed.matrix_revision(), revision);
  changed.replace(0, {2, 1, 3., 0.3});
  Point_matrix x = Point_matrix::Zero(n, 3);
  x.row(2) << 0, 1, 0;
  right_hand_side_of(changed, x); // stores the direction, for coincident ends
  changed.erase(0);
  CP::Spring_constraint_adaptor_3 made(n);
  made.insert({2, 1, 3., 0.3});
  EXPECT_EQ(matrix_of(changed), matrix_of(made));
  EXPECT_EQ(changed.energy(x), made.energy(x));
  x.row(2).setZero();
  EXPECT_LT((right_hand_side_of(changed, x).row(2) - RowVector3d(0, 0.45, 0)).norm(), 1e-15);
  changed.erase(0);
  EXPECT_EQ(matrix_of(changed).norm(), 0);
  EXPECT_THROW(changed.erase(0), CGAL::Precondition_exception);
}

// Each spring stores its last direction in case its ends coincide, even if other springs are
// removed in any way, unless its vertices change. With stored directions e_s and all points at the
// same position, row p_s of the right-hand side is kappa_s/2 r_s e_s.
TEST(Constraints, springs_remember_their_own_directions)
{
  const Point_matrix nowhere = Point_matrix::Zero(n, 3);
  Point_matrix x = nowhere;
  x.row(1) << 0, 1, 0;
  x.row(2) << 0, 0, 1;
  x.row(3) << 0, -1, 0;
  CP::Spring_constraint_adaptor_3 springs(n);
  for(std::size_t v : {1, 2, 3})
    springs.insert({v, 0, 3., 2.});
  right_hand_side_of(springs, x);
  CP::Constraint_list_3<CP::Spring_3>& list = springs;

  list.erase(0);
  Point_matrix rows = right_hand_side_of(springs, nowhere);
  EXPECT_EQ(rows.row(2), 3 * x.row(2));
  EXPECT_EQ(rows.row(3), 3 * x.row(3));

  springs.set_rest_length(0, 4.);
  springs.set_stiffness(0, 4.);
  springs.insert({1, 0, 3., 2.}); // without direction yet: the first axis
  rows = right_hand_side_of(springs, nowhere);
  EXPECT_EQ(rows.row(1), RowVector3d(3, 0, 0));
  EXPECT_EQ(rows.row(2), 8 * x.row(2));

  list.replace(0, {4, 0, 3., 2.});
  rows = right_hand_side_of(springs, nowhere);
  EXPECT_EQ(rows.row(2), RowVector3d(0, 0, 0));
  EXPECT_EQ(rows.row(3), 3 * x.row(3));
  EXPECT_EQ(rows.row(4), RowVector3d(3, 0, 0));
}

// Without pairs, all planes are equally good; the energy is 0 without a plane.
TEST(Constraints, plane_of_no_pair)
{
  CP::Symmetry_constraint_adaptor_3 pairs(n);
  const Point_matrix x = Point_matrix::Zero(n, 3);
  EXPECT_THROW(pairs.plane(x), CGAL::Precondition_exception);
  EXPECT_EQ(pairs.energy(x), 0.);
  EXPECT_EQ(right_hand_side_of(pairs, x), x);
  pairs.insert({0, 1, 1.});
  pairs.erase(0);
  EXPECT_THROW(pairs.plane(x), CGAL::Precondition_exception);
}

TEST(Constraints, bad_elements_are_named)
{
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  auto d = directions();
  auto h = handles();
  auto s = symmetry();
  EXPECT_THROW_WITH(d.insert({3, 3, RowVector3d(1, 0, 0), 1.}), std::invalid_argument,
                    "direction 2 joins vertex 3 to itself");
  EXPECT_THROW_WITH(d.insert({n, 3, RowVector3d(1, 0, 0), 1.}), std::invalid_argument,
                    "direction 2 names vertex 8, but there are 8");
  EXPECT_THROW_WITH(d.set_vector(1, RowVector3d(nan, 0, 0)), std::invalid_argument,
                    "direction 1 has a vector");
  EXPECT_THROW_WITH(h.insert({n, RowVector3d(1, 0, 0), 1.}), std::invalid_argument,
                    "handle 2 names vertex 8");
  EXPECT_THROW_WITH(h.set_position(0, RowVector3d(0, infinite, 0)), std::invalid_argument,
                    "handle 0 has a position");
  EXPECT_THROW_WITH(h.set_stiffness(0, 0.), std::invalid_argument, "handle 0 has the stiffness 0, but");
  EXPECT_THROW_WITH(s.insert({0, n, 1.}), std::invalid_argument, "symmetric pair 4 names vertex 8");
  EXPECT_THROW_WITH(s.set_stiffness(1, nan), std::invalid_argument, "symmetric pair 1");
  EXPECT_THROW(s.set_stiffness(4, 1.), CGAL::Precondition_exception);
  EXPECT_EQ(matrix_of(d), matrix_of(directions())); // unchanged
  EXPECT_EQ(matrix_of(h), matrix_of(handles()));
}

} // namespace test_constraint_lists
