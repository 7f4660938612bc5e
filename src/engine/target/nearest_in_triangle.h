// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_NEAREST_IN_TRIANGLE_H
#define CANONICAL_POSE_3_ENGINE_TARGET_NEAREST_IN_TRIANGLE_H

#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The barycentric coordinates of the point of triangle a, b, c that is nearest to p. Of a triangle
// without area, some point is returned.
inline std::array<double, 3> nearest_in_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                                 const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const double ab_from_a = ab.dot(p - a), ac_from_a = ac.dot(p - a);
  if(ab_from_a <= 0 && ac_from_a <= 0)
    return {1, 0, 0};
  const double ab_from_b = ab.dot(p - b), ac_from_b = ac.dot(p - b);
  if(ab_from_b >= 0 && ac_from_b <= ab_from_b)
    return {0, 1, 0};
  const double ab_from_c = ab.dot(p - c), ac_from_c = ac.dot(p - c);
  if(ac_from_c >= 0 && ab_from_c <= ac_from_c)
    return {0, 0, 1};
  const double of_c = ab_from_a * ac_from_b - ab_from_b * ac_from_a;
  if(of_c <= 0 && ab_from_a >= 0 && ab_from_b <= 0 && ab_from_a > ab_from_b)
  {
    const double t = ab_from_a / (ab_from_a - ab_from_b);
    return {1 - t, t, 0};
  }
  const double of_b = ab_from_c * ac_from_a - ab_from_a * ac_from_c;
  if(of_b <= 0 && ac_from_a >= 0 && ac_from_c <= 0 && ac_from_a > ac_from_c)
  {
    const double t = ac_from_a / (ac_from_a - ac_from_c);
    return {1 - t, 0, t};
  }
  const double of_a = ab_from_b * ac_from_c - ab_from_c * ac_from_b;
  const double from_b = ac_from_b - ab_from_b, from_c = ab_from_c - ac_from_c;
  if(of_a <= 0 && from_b >= 0 && from_c >= 0 && from_b + from_c > 0)
  {
    const double t = from_b / (from_b + from_c);
    return {0, 1 - t, t};
  }
  const double sum = of_a + of_b + of_c;
  if(!(sum > 0))
    return {1, 0, 0};
  return {of_a / sum, of_b / sum, of_c / sum};
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_NEAREST_IN_TRIANGLE_H
