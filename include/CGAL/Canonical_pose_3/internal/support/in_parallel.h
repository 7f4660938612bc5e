// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_IN_PARALLEL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_IN_PARALLEL_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Calls both functions, in parallel if TBB is available.
template <class First, class Second>
void in_parallel(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_invoke(first, second);
#else
  first();
  second();
#endif
}

// Calls a function whose parallel loops, while they wait, do nothing else: no other call of this kind.
template <class Function>
void isolated(const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::this_task_arena::isolate(function);
#else
  function();
#endif
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_IN_PARALLEL_H
