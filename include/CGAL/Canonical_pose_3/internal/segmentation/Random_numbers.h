// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SEGMENTATION_RANDOM_NUMBERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SEGMENTATION_RANDOM_NUMBERS_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cstddef>
#include <random>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
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
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SEGMENTATION_RANDOM_NUMBERS_H
