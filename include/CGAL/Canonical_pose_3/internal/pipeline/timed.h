// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_TIMED_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_TIMED_H

#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Adds the running time of a function, in seconds, to a stage, and returns its result.
template <class Function>
auto timed(Registration_summary& summary, const char* stage, const Function& f)
{
  Real_timer timer;
  timer.start();
  auto result = f();
  summary.add_seconds(stage, timer.time());
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_TIMED_H
