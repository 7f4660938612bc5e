// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/injective/Foldover_free_energy.h"
#include "engine/injective/Inversion_barrier.h"

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>

namespace test_injective_penalties {

namespace CP = CGAL::Canonical_pose_3;

template <class Penalty>
void expect_gradient_by_differences(const Penalty& penalty, const Eigen::Matrix3d& f)
{
  const Eigen::Matrix3d gradient = penalty.gradient(f);
  const double h = 1e-6;
  for(int k = 0; k < 9; ++k)
  {
    Eigen::Matrix3d a = f, b = f;
    a(k) -= h;
    b(k) += h;
    EXPECT_NEAR((penalty.value(b) - penalty.value(a)) / (2 * h), gradient(k),
                1e-6 * (1 + gradient.norm()));
  }
  // the approximation of the Hessian matrix must yield descent directions
  const Eigen::SelfAdjointEigenSolver<CP::internal::Matrix_9> solver(penalty.hessian(f));
  EXPECT_GE(solver.eigenvalues()[0], -1e-12 * solver.eigenvalues()[8]);
}

// Central differences are accurate to h^2 relative to the third derivatives, which are moderate for
// determinants not much smaller than epsilon or the range of the barrier.
TEST(Injective, gradients_of_the_penalties)
{
  CGAL::Random random(3);
  for(int i = 0; i < 50; ++i)
  {
    Eigen::Matrix3d f;
    for(int k = 0; k < 9; ++k)
      f(k) = random.get_double(-1, 1);
    for(const double epsilon : {1., 0.3, 0.1})
      expect_gradient_by_differences(CP::internal::Foldover_free_energy(epsilon), f);
    const double d = f.determinant();
    f *= std::cbrt(random.get_double(0.02, 0.12) / d); // not inverted, and near the barrier
    expect_gradient_by_differences(CP::internal::Inversion_barrier(), f);
  }
}

} // namespace test_injective_penalties
