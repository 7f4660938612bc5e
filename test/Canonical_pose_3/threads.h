// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_THREADS_H
#define CGAL_CANONICAL_POSE_3_TEST_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <cstddef>

namespace Canonical_pose_test {

// Calls f() on 1, 2, and 4 threads, regardless of the number of cores. Without TBB, there is
// nothing to compare, and the test is skipped.
template <class Function>
void with_each_number_of_threads(const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  for(const int threads : {1, 2, 4})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena(threads).execute(f);
  }
#else
  f();
  GTEST_SKIP() << "built without TBB: f() ran on one thread only";
#endif
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_THREADS_H
