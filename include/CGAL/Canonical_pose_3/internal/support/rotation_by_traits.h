// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_ROTATION_BY_TRAITS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_ROTATION_BY_TRAITS_H

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The rotation closest to m, computed by a model of CGAL's `DeformationClosestRotationTraits_3`;
// any rotation if m is not finite. These models return V U^t for the argument U S V^t, hence the
// transposition.
template <class ClosestRotationTraits>
Eigen::Matrix3d rotation_by_traits(const Eigen::Matrix3d& m)
{
  if(!m.allFinite())
    return Eigen::Matrix3d::Identity();
  ClosestRotationTraits traits;
  typename ClosestRotationTraits::Matrix argument = traits.zero_matrix();
  typename ClosestRotationTraits::Matrix rotation = traits.zero_matrix();
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      argument(i, j) = m(j, i);
  traits.compute_close_rotation(argument, rotation);
  Eigen::Matrix3d result;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result(i, j) = rotation(i, j);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_ROTATION_BY_TRAITS_H
