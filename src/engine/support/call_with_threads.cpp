// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Thread_limit.h"

#include <CGAL/Canonical_pose_3/call_with_threads.h>

#include <functional>

namespace CGAL {
namespace Canonical_pose_3 {

void call_with_threads(const int number_of_threads, const std::function<void()>& function)
{
  const internal::Thread_limit limit(number_of_threads);
  if(limit.is_exceeded())
    limit.execute(function);
  else
    function();
}

} // namespace Canonical_pose_3
} // namespace CGAL
