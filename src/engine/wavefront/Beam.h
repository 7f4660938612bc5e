// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_BEAM_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_BEAM_H

#include "Virtual_source.h"

#include <array>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The wave that enters a face through one of its sides, in the frame in which the side runs from
// (0,0) to (length,0) with the face above: up to three virtual sources, each of which lights a
// piece of the side, starting from the origin. The distance of a source to each point of its piece
// is at least the length of a path on the surface.
class Beam
{
public:
  static constexpr int CAPACITY = 3;

  int size() const { return m_size; }
  const Virtual_source& operator[](int i) const { return m_sources[index(i)]; }

  // the piece of source `i` reaches from begin(i) to end(i)
  double begin(int i) const { return i == 0 ? 0. : end(i - 1); }
  double end(int i) const { return m_ends[index(i)]; }

  // Adds a source that lights the remaining side up to `end`, if this piece is not empty.
  void push_back(const Virtual_source& source, double end)
  {
    if(!(end > begin(m_size)))
      return;
    m_sources[index(m_size)] = source;
    m_ends[index(m_size)] = end;
    ++m_size;
    if(m_size > CAPACITY)
      drop_one();
  }

  // Assigns the first piece to the next source, or the last piece to the previous one.
  void drop_front() { remove(0, 0); }
  void drop_back() { remove(m_size - 1, m_size - 2); }

  // distance to the point (t,0)
  double at(double t) const
  {
    int i = 0;
    while(i + 1 < m_size && t > end(i))
      ++i;
    return (*this)[i].distance(t, 0.);
  }

  // Whether source `i` is on the path to source `i` + 1, or vice versa.
  bool is_earlier(int i) const { return (*this)[i].base < (*this)[i + 1].base; }

  // The source that is on the path to the other. Its rays bound the region that it lights; the
  // other source is at their boundary.
  const Virtual_source& earlier(int i) const { return (*this)[is_earlier(i) ? i : i + 1]; }

  // The source that lights a point above the side through the side.
  int lights(double x, double y) const
  {
    int i = 0;
    while(i + 1 < m_size && earlier(i).crossing(x, y) > end(i))
      ++i;
    return i;
  }

private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  // Assigns the piece of a source to a neighbor on its path: paths become longer by a detour, never
  // too short. Chooses the source with the smallest detour.
  void drop_one()
  {
    int pair = 0;
    for(int i = 1; i + 1 < m_size; ++i)
      if(detour(i) < detour(pair))
        pair = i;
    remove(is_earlier(pair) ? pair : pair + 1, pair);
  }

  // Removes a source, and the border between pieces `border` and `border` + 1.
  void remove(int source, int border)
  {
    for(int i = source; i + 1 < m_size; ++i)
      m_sources[index(i)] = m_sources[index(i + 1)];
    for(int i = border; i + 1 < m_size; ++i)
      m_ends[index(i)] = m_ends[index(i + 1)];
    --m_size;
  }

  // how much longer the path to the far end of the piece of the earlier of the sources `i` and `i`
  // + 1 becomes through the later one
  double detour(int i) const
  {
    const double t = is_earlier(i) ? begin(i) : end(i + 1);
    const double difference = (*this)[i + 1].distance(t, 0.) - (*this)[i].distance(t, 0.);
    return is_earlier(i) ? difference : -difference;
  }

  int m_size = 0;
  std::array<Virtual_source, CAPACITY + 1> m_sources;
  std::array<double, CAPACITY + 1> m_ends;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_BEAM_H
