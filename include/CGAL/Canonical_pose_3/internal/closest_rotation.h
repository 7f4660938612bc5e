// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_CLOSEST_ROTATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_CLOSEST_ROTATION_H

#include <CGAL/Deformation_Eigen_polar_closest_rotation_traits_3.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The rotation R (determinant +1) closest to m in the Frobenius norm, by a model of CGAL's
// `DeformationClosestRotationTraits_3`. Those models return V U^t of their argument U S V^t, hence
// the transposition.
template <typename ClosestRotationTraits = Deformation_Eigen_polar_closest_rotation_traits_3>
Eigen::Matrix3d closest_rotation(const Eigen::Matrix3d& m,
                                 ClosestRotationTraits traits = ClosestRotationTraits())
{
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

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_CLOSEST_ROTATION_H
