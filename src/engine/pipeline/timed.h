// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_TIMED_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_TIMED_H

#include <CGAL/Canonical_pose_3/Registration_summary.h>

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_TIMED_H
