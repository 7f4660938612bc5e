// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_THREAD_LIMIT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_THREAD_LIMIT_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// A limit of the number of threads of a call, which does not concern other threads of the process;
// 0: no limit. A function with a limit starts with
//   if(const Thread_limit limit(number); limit.is_exceeded())
//     return limit.execute([&] { return the_function_itself(...); });
class Thread_limit
{
public:
  explicit Thread_limit(const int number_of_threads) : m_number_of_threads(number_of_threads)
  {
    require_option(number_of_threads >= 0, "number_of_threads", number_of_threads, ">= 0");
  }

  // Whether parallel loops of this thread may use more threads: not inside of execute().
  bool is_exceeded() const
  {
#ifdef CGAL_LINKED_WITH_TBB
    return m_number_of_threads > 0 && tbb::this_task_arena::max_concurrency() > m_number_of_threads;
#else
    return false;
#endif
  }

  // Calls f() in this thread, within the limit.
  template <class Function>
  auto execute(const Function& f) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    return tbb::task_arena(m_number_of_threads).execute(f);
#else
    return f();
#endif
  }

private:
  int m_number_of_threads;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_THREAD_LIMIT_H
