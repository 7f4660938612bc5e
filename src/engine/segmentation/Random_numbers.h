// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_RANDOM_NUMBERS_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_RANDOM_NUMBERS_H

#include <cstddef>
#include <random>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Random numbers that are the same with every standard library.
class Random_numbers
{
public:
  explicit Random_numbers(const unsigned int seed) : m_engine(seed) {}

  double between(const double low, const double high)
  {
    constexpr double range = 4294967296.; // of the engine
    return low + (high - low) * ((static_cast<double>(m_engine()) + .5) / range);
  }

  std::size_t below(const std::size_t n)
  {
    return static_cast<std::size_t>(between(0, static_cast<double>(n)));
  }

private:
  std::mt19937 m_engine;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_RANDOM_NUMBERS_H
