// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#else
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#endif

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

std::unique_ptr<Factor_base> make_default_factor()
{
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  return make_factor<Cholmod_factor_traits_d>();
#else
  return make_factor<Eigen_factor_traits_d>();
#endif
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
