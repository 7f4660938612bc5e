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

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Limits the number of threads during its lifetime; 0: no limit.
class Thread_limit
{
public:
  explicit Thread_limit(const int number_of_threads)
  {
    if(number_of_threads < 0)
      throw std::invalid_argument("option number_of_threads is " + std::to_string(number_of_threads)
                                  + ", but must be >= 0");
#ifdef CGAL_LINKED_WITH_TBB
    if(number_of_threads > 0)
      m_limit.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(number_of_threads));
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_limit;
#endif
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_THREAD_LIMIT_H
