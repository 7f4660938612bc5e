// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include "Supernodal_factor.h"
#else
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#endif

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

std::unique_ptr<Lane_factor_base> make_default_lane_factor()
{
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  return std::make_unique<Lane_factor_model<Supernodal_factor>>();
#else
  return std::make_unique<Lane_factor_model<Lane_factor<Eigen_factor_traits_d>>>();
#endif
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
