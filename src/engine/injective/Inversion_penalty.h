// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INJECTIVE_INVERSION_PENALTY_H
#define CANONICAL_POSE_3_ENGINE_INJECTIVE_INVERSION_PENALTY_H

#include "../energy/Elastic_cell.h"

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A function of the deformation gradient F of a cell that grows with its inversion.
class Inversion_penalty
{
public:
  virtual double value(const Eigen::Matrix3d& f) const = 0;
  virtual Eigen::Matrix3d gradient(const Eigen::Matrix3d& f) const = 0;

  // A positive semi-definite matrix near the Hessian matrix, for F column by column.
  virtual Matrix_9 hessian(const Eigen::Matrix3d& f) const = 0;

protected:
  ~Inversion_penalty() = default;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INJECTIVE_INVERSION_PENALTY_H
