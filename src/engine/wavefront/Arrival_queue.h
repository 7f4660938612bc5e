// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_ARRIVAL_QUEUE_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_ARRIVAL_QUEUE_H

#include "Beam.h"

#include <array>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The active beams, ordered by arrival time; ties are broken by storage index, which only depends
// on the order of the calls.
class Arrival_queue
{
public:
  // the distances of a beam to evenly spaced points of its side, including both ends
  using Samples = std::array<double, 4>;

  struct Arrival
  {
    int halfedge; // through which the beam enters the face
    bool is_late; // it has been postponed once
    Samples at;
    Beam beam;
  };

  bool empty() const { return m_queue.empty(); }

  void push(double time, const Arrival& arrival)
  {
    if(m_free_places.empty())
    {
      m_free_places.push_back(static_cast<int>(m_arrivals.size()));
      m_arrivals.emplace_back();
    }
    m_arrivals[static_cast<std::size_t>(m_free_places.back())] = arrival;
    m_queue.emplace(time, m_free_places.back());
    m_free_places.pop_back();
  }

  // arrival time of the next beam
  double time() const { return m_queue.top().first; }

  Arrival pop()
  {
    const int place = m_queue.top().second;
    m_queue.pop();
    m_free_places.push_back(place);
    return m_arrivals[static_cast<std::size_t>(place)];
  }

  // \pre It is empty.
  void reset()
  {
    m_arrivals.clear();
    m_free_places.clear();
  }

private:
  using Entry = std::pair<double, int>; // time and index

  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
  std::vector<Arrival> m_arrivals;
  std::vector<int> m_free_places;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_ARRIVAL_QUEUE_H
