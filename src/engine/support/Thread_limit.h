// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_THREAD_LIMIT_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_THREAD_LIMIT_H

#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_THREAD_LIMIT_H
