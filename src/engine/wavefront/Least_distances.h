// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_LEAST_DISTANCES_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_LEAST_DISTANCES_H

#include "Arrival_queue.h"
#include "Beam.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// For each halfedge, the smallest distances of any beam through it to evenly spaced points on it,
// including both ends.
class Least_distances
{
public:
  using Samples = Arrival_queue::Samples;

  explicit Least_distances(std::size_t number_of_halfedges)
    : m_least(number_of_halfedges, nowhere())
  {}

  // the distances of a beam
  static Samples samples(const Beam& beam)
  {
    const double length = beam.end(beam.size() - 1);
    Samples result;
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i]
        = beam.at(length * (static_cast<double>(i) / static_cast<double>(result.size() - 1)));
    return result;
  }

  // Whether one of the distances is the smallest so far, by a relative margin of `relative_gain`.
  bool are_least(int h, const Samples& at, double relative_gain) const
  {
    const Samples& least = m_least[static_cast<std::size_t>(h)];
    for(std::size_t i = 0; i < at.size(); ++i)
      if(relative_gain > 0 ? at[i] < least[i] * (1 - relative_gain) : at[i] <= least[i])
        return true;
    return false;
  }

  void lower(int h, const Samples& at)
  {
    Samples& least = m_least[static_cast<std::size_t>(h)];
    if(least[0] == std::numeric_limits<double>::infinity())
      m_touched.push_back(h);
    for(std::size_t i = 0; i < at.size(); ++i)
      least[i] = (std::min)(least[i], at[i]);
  }

  // Resets to infinity, in time proportional to the number of decreased distances.
  void reset()
  {
    for(int h : m_touched)
      m_least[static_cast<std::size_t>(h)] = nowhere();
    m_touched.clear();
  }

private:
  static Samples nowhere()
  {
    Samples samples;
    samples.fill(std::numeric_limits<double>::infinity());
    return samples;
  }

  std::vector<Samples> m_least;
  std::vector<int> m_touched;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_LEAST_DISTANCES_H
