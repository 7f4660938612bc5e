// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Direction_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Symmetry_constraint_adaptor_3.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <vector>

namespace test_constrained_registration {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using Eigen::RowVector3d;

// Two separate tetrahedra, each of which follows the target of its first vertex rigidly.
struct Pair
{
  Pair()
  {
    points << 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 5, 0, 0, 6, 0, 0, 5, 1, 0, 5, 0, 1;
    weights[0] = weights[4] = 1;
  }

  template <class Constraint>
  Point_matrix pose(Constraint& constraint, CP::Registration_summary& summary) const
  {
    const CP::Conforming_body_3 body(points, {{0, 1, 2, 3}, {4, 5, 6, 7}}, 8);
    Registrar registrar(body, weights, 5., Canonical_pose_test::to_the_end());
    registrar.add_constraint(constraint);
    registrar.set_target(points);
    Point_matrix result;
    summary = registrar.register_to_target(result);
    EXPECT_TRUE(summary.converged());
    EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
    EXPECT_LT(summary.energy_arap, 1e-12);
    return result;
  }

  Point_matrix points{8, 3};
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(8);
};

// All points of the bar of 12 x 2 x 2 boxes, paired with their mirror images about its middle.
CP::Symmetry_constraint_adaptor_3 symmetry_of_bar(const double stiffness)
{
  CP::Symmetry_constraint_adaptor_3 result(13 * 9);
  for(std::size_t row = 0; row < 9; ++row)
    for(std::size_t i = 0; i <= 6; ++i)
      result.insert({13 * row + i, 13 * row + 12 - i, stiffness});
  return result;
}

// Registers the bar, given its constraint, as far as possible.
CP::Registration_summary register_bar(const CP::Conforming_body_3& body, const Point_matrix& target,
                                      CP::Symmetry_constraint_adaptor_3& symmetric,
                                      Point_matrix& pose)
{
  Registrar registrar(body, uniform_weights(body.points()), 8., Canonical_pose_test::to_the_end());
  registrar.add_constraint(symmetric);
  registrar.set_target(target);
  return registrar.register_to_target(pose);
}

// For targets P, Q of weight m each and a prescribed difference d, stationarity gives p - q = (m (P
// - Q) + kappa d) / (m + kappa), and the midpoint does not move.
TEST(Constrained_registration, direction_in_equilibrium_is_exact)
{
  const Pair pair;
  const double m = 0.5;
  const RowVector3d prescribed(1, 2, 3), rest = pair.points.row(0) - pair.points.row(4);
  for(const double stiffness : {0.1, 1., 1e6})
  {
    CP::Direction_constraint_adaptor_3 directions(8);
    directions.insert({0, 4, prescribed, stiffness});
    CP::Registration_summary summary;
    const Point_matrix pose = pair.pose(directions, summary);
    const RowVector3d expected = (m * rest + stiffness * prescribed) / (m + stiffness);
    EXPECT_LT((pose.row(0) - pose.row(4) - expected).norm(), 1e-8);
    EXPECT_LT((pose.row(0) + pose.row(4) - pair.points.row(0) - pair.points.row(4)).norm(), 1e-8);
    EXPECT_NEAR(summary.energy_constraints,
                stiffness / 2 * (expected - prescribed).squaredNorm() / 25, 1e-8);
  }
}

// For a target P of weight m and the position x, p = (2 m P + kappa x) / (2 m + kappa); the other
// tetrahedron does not move.
TEST(Constrained_registration, handle_in_equilibrium_is_exact)
{
  const Pair pair;
  const double m = 0.5;
  const RowVector3d position(1, 2, 3);
  for(const double stiffness : {0.1, 1., 1e6})
  {
    CP::Handle_constraint_adaptor_3 handles(8);
    handles.insert({4, position, stiffness});
    CP::Registration_summary summary;
    const Point_matrix pose = pair.pose(handles, summary);
    const RowVector3d expected
      = (2 * m * pair.points.row(4) + stiffness * position) / (2 * m + stiffness);
    EXPECT_LT((pose.row(4) - expected).norm(), 1e-8);
    EXPECT_LT((pose.topRows<4>() - pair.points.topRows<4>()).norm(), 1e-8);
  }
}

// A symmetric target is reached as without constraint, with energy 0, regardless of its position and
// of the stiffness.
TEST(Constrained_registration, symmetric_target_costs_nothing)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2., Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const Point_matrix target
    = (body.points() * rotation.transpose()).rowwise() + RowVector3d(1, 2, 3);
  for(const double stiffness : {0.1, 1e3, 1e9})
  {
    CP::Symmetry_constraint_adaptor_3 symmetric = symmetry_of_bar(stiffness);
    Point_matrix pose;
    EXPECT_LT(register_bar(body, target, symmetric, pose).energy, 1e-12);
    EXPECT_LT((pose - target).norm(), 1e-4);
  }
}

// An asymmetric target: the stiffer the constraint, the more symmetric the pose.
TEST(Constrained_registration, symmetry_grows_with_stiffness)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  Point_matrix target = body.points();
  for(Eigen::Index i = 0; i < target.rows(); ++i)
    if(target(i, 0) < 4) // this half bends upward
    {
      const auto p
        = Canonical_pose_test::bend({4 - target(i, 0), target(i, 1), target(i, 2)}, 4, 2);
      target.row(i) << 4 - p[0], p[1], p[2];
    }
  double previous = std::numeric_limits<double>::infinity();
  for(const double stiffness : {1e-4, 1e-2, 1e2})
  {
    CP::Symmetry_constraint_adaptor_3 symmetric = symmetry_of_bar(stiffness);
    Point_matrix pose;
    const CP::Registration_summary summary = register_bar(body, target, symmetric, pose);
    EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
    const double energy = symmetric.energy(pose) / stiffness;
    EXPECT_LT(energy, previous / 2);
    previous = energy;
  }
}

} // namespace test_constrained_registration
