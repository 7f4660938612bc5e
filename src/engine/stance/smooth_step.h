// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_SMOOTH_STEP_H
#define CANONICAL_POSE_3_ENGINE_STANCE_SMOOTH_STEP_H

#include <algorithm>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// From 0 at 0 to 1 at 1, with derivatives 0 there.
inline double smooth_step(const double x)
{
  const double t = std::clamp(x, 0., 1.);
  return t * t * (3 - 2 * t);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_SMOOTH_STEP_H
