// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_INTERRUPTION_CHECK_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_INTERRUPTION_CHECK_H

#include <atomic>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// See set_interruption_check().
inline std::atomic<void (*)()> interruption_check{nullptr};

inline void call_interruption_check()
{
  if(const auto check = interruption_check.load(std::memory_order_relaxed))
    check();
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_INTERRUPTION_CHECK_H
