// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_STRESS_WEIGHTS_H
#define CANONICAL_POSE_3_ENGINE_TARGET_STRESS_WEIGHTS_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The weights of residuals of distances in units of the largest one, see Smacof_target_builder_3.
class Stress_weights
{
public:
  Stress_weights(const double exponent, const double robust_scale)
    : m_exponent(exponent), m_robust_scale(robust_scale)
  {}

  bool are_robust() const { return m_robust_scale > 0; }

  // The part that depends on the distance.
  double of_distance(const double distance) const
  {
    const double d = (std::max)(distance, 0.02);
    return m_exponent == 1 ? d : std::pow(d, m_exponent);
  }

  // The factor for a residual.
  double of_residual(const double residual) const
  {
    if(!are_robust())
      return 1;
    const double square = residual / m_robust_scale * (residual / m_robust_scale);
    return 1 / ((1 + square) * (1 + square));
  }

  // The squared residual, or, if robust, the function with these factors as weights.
  double loss(const double residual) const
  {
    const double square = residual * residual;
    return are_robust() ? square / (1 + square / (m_robust_scale * m_robust_scale)) : square;
  }

private:
  double m_exponent, m_robust_scale;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_STRESS_WEIGHTS_H
