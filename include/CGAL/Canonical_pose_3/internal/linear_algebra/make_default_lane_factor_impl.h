// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_MAKE_DEFAULT_LANE_FACTOR_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_MAKE_DEFAULT_LANE_FACTOR_IMPL_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Supernodal_factor.h>
#else
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#endif

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

CGAL_CANONICAL_POSE_3_INLINE std::unique_ptr<Lane_factor_base> make_default_lane_factor()
{
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  return std::make_unique<Lane_factor_model<Supernodal_factor>>();
#else
  return std::make_unique<Lane_factor_model<Lane_factor<Eigen_factor_traits_d>>>();
#endif
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_MAKE_DEFAULT_LANE_FACTOR_IMPL_H
