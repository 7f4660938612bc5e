// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <utility>

namespace test_arap {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using CP::Registration_summary;

using Registrar = Canonical_pose_test::Svd_registrar;

CP::Conforming_body_3 bar_body() { return Canonical_pose_test::bar_body(12, 2, 2); }

Point_matrix bent_bar_points(const double angle)
{
  return Canonical_pose_test::bar_points(12, 2, 2, angle);
}

// A moved registrar keeps factor and target.
TEST(Arap, registrars_can_be_moved)
{
  const CP::Conforming_body_3 body = bar_body();
  Registrar registrar(body, uniform_weights(body.points()), 8.);
  registrar.set_target(bent_bar_points(2.));
  registrar.factor();
  Point_matrix pose, pose_of_moved;
  const Registration_summary summary = registrar.register_to_target(pose);
  Registrar moved(std::move(registrar));
  const Registration_summary summary_of_moved = moved.register_to_target(pose_of_moved);
  EXPECT_EQ(pose_of_moved, pose);
  EXPECT_EQ(summary_of_moved.energy_history, summary.energy_history);
}

// A target that is a rigid motion of the rest pose has E = 0, and rotations fitted to it are exact:
// the iteration ends at the target immediately. Large rotations are no harder than small ones.
TEST(Arap, rigid_target_is_reached_with_energy_zero)
{
  const CP::Conforming_body_3 body = bar_body();
  Registrar registrar(body, uniform_weights(body.points()), 8.);
  for(const double angle : {0., 0.3, 2., 3.1415})
  {
    const Eigen::Matrix3d rotation
      = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const Point_matrix target
      = (body.points() * rotation.transpose()).rowwise() + Eigen::RowVector3d(3, 2, 1);
    registrar.set_target(target);
    Point_matrix pose;
    const Registration_summary summary = registrar.register_to_target(pose);
    EXPECT_TRUE(summary.converged());
    EXPECT_LT(summary.energy, 1e-24);
    EXPECT_LT((pose - target).norm(), 1e-11);
    EXPECT_NEAR(summary.volume_ratio, 1., 1e-12);
    EXPECT_EQ(summary.inverted, 0u);
  }
}

// At a minimum the gradient vanishes. The gradient is checked by central differences of the energy,
// which is reevaluated (zero iterations from a warm start), so that errors in matrix or right-hand
// side are detected. Inverted cells would be untangled by each evaluation, hence remain.
TEST(Arap, result_is_a_stationary_point_of_the_reported_energy)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(3, 1, 1);
  const Point_matrix target = Canonical_pose_test::bar_points(3, 1, 1, 2.) * 1.1;
  CP::Registration_options options;
  options.injective = false;
  options.number_of_iterations = 5000;
  options.energy_tolerance = 0;
  options.move_tolerance = 1e-13;
  Registrar registrar(body, uniform_weights(target), 8., options);
  registrar.set_target(target);
  Point_matrix pose;
  registrar.register_to_target(pose);

  registrar.set_number_of_iterations(0);
  const auto energy = [&](Point_matrix v) { return registrar.register_to_target(v).energy; };
  const double step = 1e-5;
  for(Eigen::Index i = 0; i < pose.rows(); ++i)
    for(Eigen::Index k = 0; k < 3; ++k)
    {
      Point_matrix up = pose, down = pose;
      up(i, k) += step;
      down(i, k) -= step;
      EXPECT_LT(std::abs(energy(up) - energy(down)) / (2 * step), 1e-8) << i << ' ' << k;
    }
}

// Both steps minimize E over their unknowns, so it cannot increase, even with a Tikhonov term.
// Random targets, some of them mirrored, so that cells are inverted; they are not untangled here.
TEST(Arap, energy_never_rises)
{
  const CP::Conforming_body_3 body = bar_body();
  CGAL::Random random(3);
  for(int run = 0; run < 8; ++run)
  {
    CP::Registration_options options;
    options.injective = false;
    options.detail_length = random.get_double(0.02, 0.5);
    options.tikhonov = run % 2 == 0 ? 0. : random.get_double(0., 5.);
    Registrar registrar(body, uniform_weights(body.points()), 8., options);
    Point_matrix target = bent_bar_points(random.get_double(-3., 3.));
    for(Eigen::Index i = 0; i < target.size(); ++i)
      target.data()[i] += random.get_double(-0.5, 0.5);
    if(run > 5)
      target.col(1) *= -1;
    registrar.set_target(target);
    Point_matrix pose;
    const Registration_summary summary = registrar.register_to_target(pose);
    EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history)) << run;
    EXPECT_TRUE(pose.allFinite());
  }
}

// All lengths are relative to L: scaling body, target and L by a power of two scales the pose, bit
// by bit.
TEST(Arap, units_do_not_matter)
{
  const auto pose_in_unit = [](const double unit) {
    Canonical_pose_test::Tetrahedral_soup soup
      = Canonical_pose_test::tetrahedral_bent_bar(12, 2, 2, 0.);
    for(auto& p : soup.points)
      for(double& x : p)
        x *= unit;
    const CP::Conforming_body_3 body = Canonical_pose_test::to_body(soup);
    Registrar registrar(body, uniform_weights(body.points()), 8. * unit);
    registrar.set_target(unit * bent_bar_points(2.5));
    Point_matrix pose;
    registrar.register_to_target(pose);
    return Point_matrix(pose / unit);
  };
  const Point_matrix pose = pose_in_unit(1.);
  EXPECT_EQ(pose_in_unit(1024.), pose);
  EXPECT_EQ(pose_in_unit(std::exp2(-200)), pose);
  EXPECT_LT((pose_in_unit(1e6) - pose).norm(), 1e-6);
  EXPECT_LT((pose_in_unit(1e-6) - pose).norm(), 1e-6);
}

// The two solvers factor the same matrix, and rotations in closed form agree with those of CGAL's
// singular value decomposition: same pose up to rounding.
TEST(Arap, solvers_and_rotations_agree)
{
  const CP::Conforming_body_3 body = bar_body();
  const auto pose_of = [&](auto registrar) {
    registrar.set_target(bent_bar_points(2.));
    Point_matrix pose;
    EXPECT_TRUE(registrar.register_to_target(pose).converged());
    return pose;
  };
  const Eigen::VectorXd weights = uniform_weights(body.points());
  const Point_matrix pose = pose_of(Registrar(body, weights, 8.));
  using Eigen_registrar
    = CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3,
                                       CGAL::Deformation_Eigen_closest_rotation_traits_3,
                                       CP::Eigen_factor_traits_d>;
  EXPECT_LT((pose_of(Eigen_registrar(body, weights, 8.)) - pose).norm(), 1e-9);
  EXPECT_LT((pose_of(Canonical_pose_test::Registrar(body, weights, 8.)) - pose).norm(), 1e-9);
}

// A warm start from the result converges immediately; a smaller detail length yields a pose closer
// to the target. Inverted cells remain, so that the result is where the iteration ended.
TEST(Arap, warm_start_and_detail_length)
{
  const CP::Conforming_body_3 body = bar_body();
  const Point_matrix target = bent_bar_points(3.) * Eigen::Vector3d(1, 0.5, 1).asDiagonal();
  double previous = std::numeric_limits<double>::infinity();
  for(const double detail_length : {0.4, 0.1, 0.025})
  {
    CP::Registration_options options;
    options.injective = false;
    options.detail_length = detail_length;
    Registrar registrar(body, uniform_weights(target), 8., options);
    registrar.set_target(target);
    Point_matrix pose;
    const Registration_summary cold = registrar.register_to_target(pose);
    const Registration_summary warm = registrar.register_to_target(pose);
    EXPECT_LE(warm.iterations, 1);
    EXPECT_NEAR(warm.energy, cold.energy, 1e-4 * cold.energy);
    EXPECT_LT(cold.energy_match, previous);
    previous = cold.energy_match;
  }
}

// A body vertex without target (weight 0) follows its neighbors: exactly, for a rigid target.
TEST(Arap, vertices_without_target_follow)
{
  const CP::Conforming_body_3 body = bar_body();
  Eigen::VectorXd weights = uniform_weights(body.points());
  for(Eigen::Index i = 1; i < weights.size(); i += 3)
    weights[i] = 0;
  CP::Registration_options options;
  options.energy_tolerance = 1e-12;
  options.move_tolerance = 1e-9;
  Registrar registrar(body, weights, 8., options);
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2., Eigen::Vector3d::UnitY()).toRotationMatrix();
  Point_matrix target = body.points() * rotation.transpose();
  for(Eigen::Index i = 1; i < weights.size(); i += 3)
    target.row(i).setConstant(100); // must not matter
  registrar.set_target(target);
  Point_matrix pose;
  EXPECT_TRUE(registrar.register_to_target(pose).converged());
  EXPECT_LT((pose - body.points() * rotation.transpose()).norm(), 1e-5);
}

} // namespace test_arap
