// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INJECTIVE_INVERSION_BARRIER_H
#define CANONICAL_POSE_3_ENGINE_INJECTIVE_INVERSION_BARRIER_H

#include "Inversion_penalty.h"
#include "../energy/Elastic_cell.h"

#include <CGAL/Canonical_pose_3/internal/linear_algebra/factor_failures.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The positive semi-definite matrix closest to a symmetric one.
inline Matrix_9 positive_part(const Matrix_9& m)
{
  const std::optional<Eigenpairs> pairs = all_eigenpairs(m);
  if(!pairs)
    throw Ill_conditioned("the eigenvalues of a Hessian matrix could not be computed");
  const Matrix_9 vectors = pairs->vectors;
  const Vector_9 values = pairs->values.cwiseMax(0);
  return vectors * values.asDiagonal() * vectors.transpose();
}

// A function of the deformation gradient F of a cell that keeps its determinant positive:
//   b(F) = (1 - y)^3 / y  with  y = det F / ACTIVE_BELOW < 1,  otherwise 0, infinite if det F <= 0.
// It is twice continuously differentiable where det F > 0.
class Inversion_barrier final : public Inversion_penalty
{
public:
  static constexpr double ACTIVE_BELOW = 0.1;

  double value(const Eigen::Matrix3d& f) const override
  {
    const double y = f.determinant() / ACTIVE_BELOW;
    return y >= 1  ? 0
           : y > 0 ? (1 - y) * (1 - y) * (1 - y) / y
                   : std::numeric_limits<double>::infinity();
  }

  Eigen::Matrix3d gradient(const Eigen::Matrix3d& f) const override
  {
    const double y = f.determinant() / ACTIVE_BELOW;
    if(y >= 1)
      return Eigen::Matrix3d::Zero();
    return (-1 / (y * y) + 3 - 2 * y) / ACTIVE_BELOW * cofactors(f);
  }

  // The positive semidefinite matrix closest to the Hessian matrix, with F stored column by column.
  Matrix_9 hessian(const Eigen::Matrix3d& f) const override
  {
    const double y = f.determinant() / ACTIVE_BELOW;
    if(y >= 1)
      return Matrix_9::Zero();
    const Vector_9 c = cofactors(f).reshaped();
    return positive_part((2 / (y * y * y) - 2) / (ACTIVE_BELOW * ACTIVE_BELOW) * c * c.transpose()
                         + (-1 / (y * y) + 3 - 2 * y) / ACTIVE_BELOW * determinant_hessian(f));
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INJECTIVE_INVERSION_BARRIER_H
