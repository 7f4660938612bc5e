// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_MAKE_DEFAULT_FACTOR_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_MAKE_DEFAULT_FACTOR_IMPL_H

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

CGAL_CANONICAL_POSE_3_INLINE std::unique_ptr<Factor_base> make_default_factor()
{
  return make_factor<Default_factor_traits_d>();
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_MAKE_DEFAULT_FACTOR_IMPL_H
