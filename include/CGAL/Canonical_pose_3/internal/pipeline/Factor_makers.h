// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_FACTOR_MAKERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_FACTOR_MAKERS_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// What makes the factors of a linear solver; null for that of the options.
struct Factor_makers
{
  Factor_maker factor_maker = nullptr;
  Lane_factor_maker lane_factor_maker = nullptr;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_FACTOR_MAKERS_H
