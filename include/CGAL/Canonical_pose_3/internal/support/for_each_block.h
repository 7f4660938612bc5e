// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H

#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Divides [0, n) into blocks of fixed size and calls f(block, begin, end) for each, in parallel if
// TBB is available. The blocks, and thus sums per block, do not depend on the number of threads.
inline constexpr std::size_t block_size = 1024;

inline std::size_t number_of_blocks(const std::size_t n, const std::size_t size = block_size)
{
  return (n + size - 1) / size;
}

template <class Function>
void for_each_block(const std::size_t n, const Function& f, const std::size_t size = block_size)
{
  for_each_index(number_of_blocks(n, size), [&](const std::size_t block) {
    f(block, block * size, (std::min)(n, (block + 1) * size));
  });
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H
