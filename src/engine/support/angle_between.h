// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_ANGLE_BETWEEN_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_ANGLE_BETWEEN_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Of vectors with three coordinates, in radians, from 0; accurate for small and large angles, too.
template <class A, class B>
double angle_between(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_ANGLE_BETWEEN_H
