// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INJECTIVE_INVERSION_PENALTY_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INJECTIVE_INVERSION_PENALTY_H

#include <CGAL/Canonical_pose_3/internal/energy/Elastic_cell.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
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
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INJECTIVE_INVERSION_PENALTY_H
