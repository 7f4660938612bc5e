// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_BEAM_PASSAGE_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_BEAM_PASSAGE_H

#include "Beam.h"
#include "Virtual_source.h"

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// How a beam passes the third corner of the face that it has entered: either one of its sources
// lights the corner, or the corner is hidden by an end of the side, around which the path bends.
class Beam_passage
{
public:
  // `is_origin_flat`, `is_target_flat`: of the ends of the side
  Beam_passage(const Beam& beam, double apex_x, double apex_y, bool is_origin_flat,
               bool is_target_flat)
    : m_beam(beam), m_source(beam.lights(apex_x, apex_y)), m_length(beam.end(beam.size() - 1)),
      m_straight(beam[m_source].distance(apex_x, apex_y)), m_is_origin_flat(is_origin_flat),
      m_is_target_flat(is_target_flat)
  {
    const double t = beam[m_source].crossing(apex_x, apex_y);
    m_is_left = m_source == 0 && t < 0;
    m_is_right = m_source + 1 == beam.size() && t > m_length;
  }

  // whether the corner is hidden behind the origin, or the target, of the side, or one of them
  bool is_left() const { return m_is_left; }
  bool is_right() const { return m_is_right; }
  bool is_hidden() const { return m_is_left || m_is_right; }

  bool is_hidden_by_flat() const
  {
    return (m_is_left && m_is_origin_flat) || (m_is_right && m_is_target_flat);
  }

  // distance to the corner if it were not hidden
  double straight() const { return m_straight; }

  // the beam on the next side, from the corner to the target of this side
  Beam over_next(const Unfolded_side& exit) const
  {
    return over(exit, m_is_right ? m_beam.size() : m_source, m_beam.size());
  }

  // the beam on the previous side, from the origin of this side to the corner
  Beam over_previous(const Unfolded_side& exit) const
  {
    return over(exit, 0, m_is_left ? 0 : m_source + 1);
  }

private:
  // sources `first` to `last` - 1, and the end of the side at which the path bends
  Beam over(const Unfolded_side& exit, int first, int last) const
  {
    Beam result;
    if(m_is_left)
      result.push_back(exit.in_frame({0., 0., m_beam.at(0.), m_is_origin_flat}),
                       first < last ? exit.arrival(m_beam[first], 0.) : exit.length);
    for(int k = first; k < last; ++k)
      result.push_back(exit.in_frame(m_beam[k]), k + 1 < last
                                                   ? exit.arrival(m_beam.earlier(k), m_beam.end(k))
                                                 : m_is_right ? exit.arrival(m_beam[k], m_length)
                                                              : exit.length);
    if(m_is_right)
      result.push_back(exit.in_frame({m_length, 0., m_beam.at(m_length), m_is_target_flat}),
                       exit.length);
    return result;
  }

  const Beam& m_beam;
  int m_source;
  double m_length, m_straight;
  bool m_is_origin_flat, m_is_target_flat;
  bool m_is_left, m_is_right;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_BEAM_PASSAGE_H
