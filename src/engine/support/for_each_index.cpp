// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/set_interruption_check.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline std::atomic<void (*)()> interruption_check{nullptr};

inline void call_interruption_check()
{
  if(const auto check = interruption_check.load(std::memory_order_relaxed))
    check();
}

void for_each_index(const std::size_t n, const Index_function f)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n),
                    [f](const tbb::blocked_range<std::size_t>& indices) {
                      for(std::size_t i = indices.begin(); i != indices.end(); ++i)
                      {
                        call_interruption_check();
                        f(i);
                      }
                    });
#else
  for(std::size_t i = 0; i < n; ++i)
  {
    call_interruption_check();
    f(i);
  }
#endif
}

} // namespace internal

void set_interruption_check(void (*const check)()) { internal::interruption_check = check; }

} // namespace Canonical_pose_3
} // namespace CGAL
