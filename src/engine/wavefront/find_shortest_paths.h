// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_FIND_SHORTEST_PATHS_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_FIND_SHORTEST_PATHS_H

#include <CGAL/exceptions.h>

#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Calls f, which calls CGAL's shortest paths. Converts exceptions of their assertions, if enabled.
template <class Function>
void find_shortest_paths(const Function& f)
{
  try
  {
    f();
  }
  catch(const Failure_exception& failure)
  {
    throw std::runtime_error("exact distances could not be computed: CGAL's shortest paths failed ("
                             + failure.expression() + ")");
  }
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_FIND_SHORTEST_PATHS_H
