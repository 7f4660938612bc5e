// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "interruption_check.h"

#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

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
} // namespace Canonical_pose_3
} // namespace CGAL
