// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INJECTIVE_FOLDOVER_FREE_ENERGY_H
#define CANONICAL_POSE_3_ENGINE_INJECTIVE_FOLDOVER_FREE_ENERGY_H

#include "Inversion_penalty.h"
#include "../energy/Elastic_cell.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The energy of Garanzha et al., Foldover-free maps in 50 lines of code, ACM TOG 2021 (Equation 3), of
// the deformation gradient F of a cell, d = det F:
//   |F|^2 / (3 x^(2/3)) + (d^2 + 1) / (2 x)  with  x = (d + sqrt(epsilon^2 + d^2)) / 2 > 0.
// It is 2 at rotations if epsilon is 0. The smaller epsilon, the higher the energy of inverted
// cells.
class Foldover_free_energy final : public Inversion_penalty
{
public:
  // `epsilon`: positive.
  explicit Foldover_free_energy(const double epsilon) : m_epsilon(epsilon) {}

  double value(const Eigen::Matrix3d& f) const override
  {
    const Regularised_determinant r(f.determinant(), m_epsilon);
    return f.squaredNorm() * r.power / 3 + (r.d * r.d + 1) / (2 * r.x);
  }

  Eigen::Matrix3d gradient(const Eigen::Matrix3d& f) const override
  {
    const Regularised_determinant r(f.determinant(), m_epsilon);
    const double by_determinant
      = -2. / 9 * f.squaredNorm() * r.power / r.root + (r.d - (r.d * r.d + 1) / (2 * r.root)) / r.x;
    return 2 * r.power / 3 * f + by_determinant * cofactors(f);
  }

  // The Hessian matrix, with F stored column by column, without the second derivative of det F; a
  // multiple of the outer product of the gradient of det F is added to make it positive
  // semidefinite.
  Matrix_9 hessian(const Eigen::Matrix3d& f) const override
  {
    const Regularised_determinant r(f.determinant(), m_epsilon);
    const double shape = f.squaredNorm() * r.power / (r.root * r.root);
    const double bend = m_epsilon * m_epsilon / (2 * r.root * r.root * r.root) / r.x; // x'' / x
    const double volume = (r.d * r.d + 1) / r.x;
    const double second = shape * 10 / 27 - f.squaredNorm() * r.power * bend * 2 / 9 + 1 / r.x
                          - 2 * r.d / (r.x * r.root) + volume * (1 / (r.root * r.root) - bend / 2);
    const Vector_9 c = cofactors(f).reshaped(), v = f.reshaped();
    Matrix_9 result = (std::max)(second, shape * 8 / 27) * c * c.transpose();
    result.diagonal().array() += 2 * r.power / 3;
    const Matrix_9 mixed = -4. / 9 * r.power / r.root * v * c.transpose();
    return result + mixed + mixed.transpose();
  }

private:
  struct Regularised_determinant
  {
    // x' is x / root
    double d, root, x, power;

    Regularised_determinant(const double determinant, const double epsilon)
      : d(determinant), root(std::hypot(epsilon, d)),
        x(d > 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d))), // avoids cancellation
        power(std::pow(x, -2. / 3))
    {}
  };

  double m_epsilon;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INJECTIVE_FOLDOVER_FREE_ENERGY_H
