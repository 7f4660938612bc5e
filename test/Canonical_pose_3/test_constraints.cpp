// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include "constraint_samples.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace test_constraints {

using namespace Canonical_pose_test;

constexpr int n = number_of_points;

Point_matrix random_points(CGAL::Random& random, const double size = 1)
{
  Point_matrix points(n, 3);
  for(Eigen::Index i = 0; i < points.size(); ++i)
    points.data()[i] = random.get_double(-size, size);
  return points;
}

// The requirement of the concept that implies that the energy of a registration never increases:
// q(y) = tr(y^t C y) - 2 tr(y^t D(x)) + const is above e(y) everywhere and touches it at x. Hence
// the gradient of e at x is 2 (C x - D(x)), which is compared with central differences.
template <class Constraint>
void expect_majorised(Constraint constraint)
{
  CGAL::Random random(7);
  const Eigen::MatrixXd c = matrix_of(constraint);
  EXPECT_EQ(c, c.transpose());
  for(int trial = 0; trial < 50; ++trial)
  {
    const Point_matrix x = random_points(random), d = right_hand_side_of(constraint, x);
    const auto q = [&](const Point_matrix& y) {
      return y.cwiseProduct(c * y - 2 * d).sum() - x.cwiseProduct(c * x - 2 * d).sum()
             + constraint.energy(x);
    };
    for(const double size : {1e-3, 0.1, 10.})
    {
      const Point_matrix y = x + random_points(random, size);
      EXPECT_GE(q(y) - constraint.energy(y), -1e-11 * (1 + q(y)));
    }
    const double h = 1e-5;
    const Point_matrix way = random_points(random);
    const double slope
      = (constraint.energy(x + h * way) - constraint.energy(x - h * way)) / (2 * h);
    EXPECT_NEAR(2 * way.cwiseProduct(c * x - d).sum(), slope, 1e-6 * (1 + std::abs(slope)));
  }
}

const Eigen::Matrix3d rotation
  = Eigen::AngleAxisd(2., Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix().transpose();
const RowVector3d translation(3, -1, 2);

template <class Constraint, class Moved>
void expect_same_energy_when_moved(const Constraint& constraint, const Moved& moved)
{
  CGAL::Random random(8);
  const Point_matrix x = random_points(random);
  const double energy = constraint.energy(x);
  EXPECT_GT(energy, 0.01);
  EXPECT_NEAR(moved.energy((x * rotation).rowwise() + translation), energy, 1e-12 * energy);
}

TEST(Constraints, energies_are_majorised_and_have_their_gradient)
{
  expect_majorised(springs());
  expect_majorised(directions());
  expect_majorised(handles());
  expect_majorised(symmetry());
}

TEST(Constraints, energies_follow_rigid_motions)
{
  expect_same_energy_when_moved(springs(), springs());
  expect_same_energy_when_moved(symmetry(), symmetry());
  CP::Direction_constraint_adaptor_3 moved_directions = directions();
  CP::Handle_constraint_adaptor_3 moved_handles = handles();
  for(std::size_t i = 0; i < 2; ++i)
  {
    moved_directions.set_vector(i, moved_directions.element(i).vector * rotation);
    moved_handles.set_position(i, moved_handles.element(i).position * rotation + translation);
  }
  expect_same_energy_when_moved(directions(), moved_directions);
  expect_same_energy_when_moved(handles(), moved_handles);
}

// Compares the formula with a search over the hemisphere of normals, for each of which the best
// offset is the weighted mean. The samples are about 0.01 apart, so the best one is near the
// minimum.
TEST(Constraints, plane_of_symmetry_is_the_best_of_all)
{
  CGAL::Random random(9);
  for(int trial = 0; trial < 3; ++trial)
  {
    const CP::Symmetry_constraint_adaptor_3 constraint = symmetry();
    const Point_matrix x = random_points(random);
    double best = std::numeric_limits<double>::infinity();
    constexpr int N = 40000;
    for(int k = 0; k < N; ++k) // Fibonacci spiral
    {
      const double z = (k + 0.5) / N, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * k;
      const RowVector3d normal(r * std::cos(angle), r * std::sin(angle), z);
      double weights = 0, offset = 0, sum = 0;
      for(const auto& s : constraint.elements())
      {
        weights += s.stiffness;
        offset += s.stiffness * normal.dot(x.row(s.p) + x.row(s.q)) / 2;
      }
      offset /= weights;
      for(const auto& s : constraint.elements())
      {
        const RowVector3d image = x.row(s.q) - 2 * (normal.dot(x.row(s.q)) - offset) * normal;
        sum += s.stiffness / 2 * (x.row(s.p) - image).squaredNorm();
      }
      best = (std::min)(best, sum);
    }
    EXPECT_LE(constraint.energy(x), best * (1 + 1e-12));
    EXPECT_NEAR(constraint.energy(x), best, 1e-3 * best);
  }
}

// The energy of a symmetric point set is 0, regardless of position and unit; so is that of
// coincident points, which have no plane.
TEST(Constraints, symmetric_points_have_energy_zero)
{
  CGAL::Random random(10);
  Point_matrix x = random_points(random);
  x.bottomRows<4>() = x.topRows<4>() * Eigen::Vector3d(-1, 1, 1).asDiagonal();
  x(3, 0) = 0; // paired with itself
  for(const double unit : {1e-120, 1., 1e120})
  {
    const Point_matrix moved = unit * ((x * rotation).rowwise() + translation);
    EXPECT_LT(symmetry().energy(moved) / unit / unit, 1e-24);
    EXPECT_LT(std::abs((symmetry().plane(moved).normal() - rotation.row(0).transpose()).norm() - 1),
              1 + 1e-9);
  }
  const Point_matrix one_place = RowVector3d(1, 2, 3).replicate(n, 1);
  EXPECT_LT(symmetry().energy(one_place), 1e-28);
}

} // namespace test_constraints
