// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_IN_PARALLEL_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_IN_PARALLEL_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Calls both functions, in parallel if TBB is available. If both throw, the first exception remains.
template <class First, class Second>
void in_parallel(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  std::array<std::exception_ptr, 2> errors;
  const auto call = [](const auto& function, std::exception_ptr& error) {
    try
    {
      function();
    }
    catch(...)
    {
      error = std::current_exception();
    }
  };
  tbb::parallel_invoke([&] { call(first, errors[0]); }, [&] { call(second, errors[1]); });
  for(const std::exception_ptr& error : errors)
    if(error)
      std::rethrow_exception(error);
#else
  first();
  second();
#endif
}

// Sorts values, no two of which are equivalent, in parallel if TBB is available.
template <class Value>
void sort_in_parallel(std::vector<Value>& values)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_sort(values.begin(), values.end());
#else
  std::sort(values.begin(), values.end());
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_IN_PARALLEL_H
