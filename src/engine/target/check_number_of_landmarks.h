// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_CHECK_NUMBER_OF_LANDMARKS_H
#define CANONICAL_POSE_3_ENGINE_TARGET_CHECK_NUMBER_OF_LANDMARKS_H

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Checks that the distances of n vertices to at most n landmarks fit into memory, and that the
// landmarks can be embedded.
inline void check_number_of_landmarks(const std::size_t number_of_landmarks, const std::size_t n)
{
  constexpr std::size_t largest_number = 4096, largest_number_of_distances = std::size_t(1) << 29;
  const std::size_t largest
    = (std::min)(largest_number, largest_number_of_distances / (std::max)(n, std::size_t(1)));
  if((std::min)(number_of_landmarks, n) > largest)
    throw std::invalid_argument(
      "option number_of_landmarks is " + std::to_string(number_of_landmarks) + ", but must be <= "
      + std::to_string(largest) + " for a surface of " + std::to_string(n) + " vertices");
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_CHECK_NUMBER_OF_LANDMARKS_H
