// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Direction_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Symmetry_constraint_adaptor_3.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_all_constraints {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;

// One constraint of each kind on the bar; `motion` is applied to everything that depends on the
// frame.
struct All_kinds
{
  explicit All_kinds(const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity())
  {
    const auto moved
      = [&](const Eigen::Vector3d& p) -> Eigen::RowVector3d { return (motion * p).transpose(); };
    springs.insert({3, 100, 1., 0.2});
    directions.insert({0, 12, (motion.linear() * Eigen::Vector3d(0, 6, 1)).transpose(), 0.1});
    handles.insert({58, moved({0.5, 1, -1}), 0.4});
    symmetric.insert({13, 25, 0.3});
    symmetric.insert({26, 38, 0.2});
    symmetric.insert({84, 84, 0.1});
  }

  void add_to(Registrar& registrar)
  {
    registrar.add_constraint(springs);
    registrar.add_constraint(directions);
    registrar.add_constraint(handles);
    registrar.add_constraint(symmetric);
  }

  CP::Spring_constraint_adaptor_3 springs{117};
  CP::Direction_constraint_adaptor_3 directions{117};
  CP::Handle_constraint_adaptor_3 handles{117};
  CP::Symmetry_constraint_adaptor_3 symmetric{117};
};

// The final energy is stationary: its central differences vanish in every direction. They would not
// if matrix, right-hand side and energy were inconsistent.
TEST(All_constraints, ends_where_the_gradient_vanishes)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  Registrar registrar(body, uniform_weights(body.points()), 8., Canonical_pose_test::to_the_end());
  All_kinds constraints;
  constraints.add_to(registrar);
  registrar.set_target(Canonical_pose_test::bar_points(12, 2, 2, 1.5));
  Point_matrix pose;
  const CP::Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_TRUE(summary.converged());
  EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
  EXPECT_GT(summary.energy_constraints, 1e-4);

  registrar.set_number_of_iterations(0); // only evaluates the energy
  const auto energy
    = [&](Point_matrix points) { return registrar.register_to_target(points).energy; };
  CGAL::Random random(3);
  for(int trial = 0; trial < 10; ++trial)
  {
    Point_matrix way(pose.rows(), 3);
    for(Eigen::Index i = 0; i < way.size(); ++i)
      way.data()[i] = random.get_double(-1, 1);
    const double h = 1e-4;
    const double slope = (energy(pose + h * way) - energy(pose - h * way)) / (2 * h);
    const double curvature
      = (energy(pose + h * way) - 2 * summary.energy + energy(pose - h * way)) / (h * h);
    EXPECT_LT(std::abs(slope), 1e-6 * curvature);
  }
}

// If everything is moved rigidly, including given vectors and positions, so is the pose.
TEST(All_constraints, follows_rigid_motions)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(12, 2, 2);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 1).normalized()));
  motion.pretranslate(Eigen::Vector3d(4, 5, -6));
  Point_matrix poses[2];
  for(const bool is_moved : {false, true})
  {
    Registrar registrar(body, uniform_weights(body.points()), 8.,
                        Canonical_pose_test::to_the_end());
    All_kinds constraints(is_moved ? motion : Eigen::Isometry3d::Identity());
    constraints.add_to(registrar);
    const Point_matrix target = Canonical_pose_test::bar_points(12, 2, 2, 1.5);
    registrar.set_target(is_moved ? Point_matrix((motion * target.transpose()).transpose())
                                  : target);
    registrar.register_to_target(poses[is_moved]);
  }
  EXPECT_LT(((motion * poses[0].transpose()).transpose() - poses[1]).norm(), 1e-5);
}

} // namespace test_all_constraints
