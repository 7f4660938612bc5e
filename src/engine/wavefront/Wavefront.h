// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_WAVEFRONT_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_WAVEFRONT_H

#include "Arrival_queue.h"
#include "Beam.h"
#include "Beam_passage.h"
#include "Least_distances.h"
#include "Unfolded_sides.h"

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <queue>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A wave that propagates over the faces from a source, by increasing distance, and decreases the
// distances of the vertices to which it finds a shorter path.
//
// A beam crosses a side and lights all of it. In the next face, the beam reaches the third corner
// and leaves through the two other sides. If a corner hides a part of them, the path bends there,
// and the corner becomes a source. Sides do not store beams, only the smallest distances so far of
// four of their points: a beam is propagated if it is the best at one of them. Hence at most four
// beams per side matter, and memory and, in practice, time are linear, up to the queue.
class Wavefront
{
public:
  // `sides` must outlive this object
  explicit Wavefront(const Unfolded_sides& sides)
    : m_sides(&sides), m_least(sides.number_of_halfedges())
  {}

  // Decreases the distances to those from `source` if these are smaller. The wave stops where it
  // does not decrease any distance, so a source near others only visits the vertices nearer to it.
  // `distances`: one number per vertex, initially +infinity
  void lower(int source, Eigen::VectorXd& distances) { lower(std::vector<int>{source}, distances); }

  // the same for several sources at once
  void lower(const std::vector<int>& sources, Eigen::VectorXd& distances)
  {
    for(int source : sources)
      lower_to(0., source, false, distances);
    for(int source : sources)
      leave(source, true, distances);
    while(!m_queue.empty() || !m_vertices.empty())
      if(m_queue.empty() || (!m_vertices.empty() && m_vertices.top().distance <= m_queue.time()))
        settle(distances);
      else
        arrive(distances);
    // prepares for the next wave
    m_least.reset();
    m_queue.reset();
  }

private:
  // below it, differences of two beams from the same source are rounding errors
  static constexpr double TOLERANCE = 1e-13;
  // up to it, two distances are considered those from the same source along different paths
  static constexpr double SAME = 1e-11;

  using Arrival = Arrival_queue::Arrival;

  struct Reached
  {
    double distance;
    int vertex;
    bool is_bent;

    friend bool operator>(const Reached& a, const Reached& b)
    {
      return a.distance != b.distance ? a.distance > b.distance : a.vertex > b.vertex;
    }
  };

  // A vertex that was reached along an edge is a source: possibly no beam lights the faces behind
  // it, for instance if the vertex is one of two ears of the surface.
  void settle(Eigen::VectorXd& distances)
  {
    const Reached reached = m_vertices.top();
    m_vertices.pop();
    if(reached.distance == distances[reached.vertex])
      leave(reached.vertex, reached.is_bent || m_sides->is_border(reached.vertex), distances);
  }

  void arrive(Eigen::VectorXd& distances)
  {
    Arrival arrival = m_queue.pop();
    widen(arrival, distances);
    if(m_least.are_least(arrival.halfedge, arrival.at, 0.)
       && !is_dominated(arrival.halfedge, arrival.at, distances))
      cross(arrival, distances);
  }

  // `is_bent`: by a path whose last segment is an edge
  void lower_to(double distance, int vertex, bool is_bent, Eigen::VectorXd& distances)
  {
    if(!(distance < distances[vertex] * (1 - (is_bent ? TOLERANCE : 0.))))
      return;
    distances[vertex] = distance;
    m_vertices.push({distance, vertex, is_bent});
  }

  // Propagates from a vertex to its neighbors, and sends a beam through the opposite side of each
  // of its faces.
  void leave(int vertex, bool shines, Eigen::VectorXd& distances)
  {
    const double base = distances[vertex];
    m_sides->for_each_outgoing(vertex, [&](int h) {
      const int opposite = Unfolded_sides::next(h), last = Unfolded_sides::previous(h);
      lower_to(base + (*m_sides)[h].length, m_sides->target(h), true, distances);
      lower_to(base + (*m_sides)[last].length, (*m_sides)[last].origin, true, distances);
      if(!shines)
        return;
      const auto& side = (*m_sides)[opposite];
      Beam beam;
      beam.push_back({side.length - side.apex_x, -side.apex_y, base, false}, side.length);
      enter(side.twin, beam, distances);
    });
  }

  // Inserts the beam that enters a face through `h` into the queue, unless it is useless.
  void enter(int h, const Beam& beam, const Eigen::VectorXd& distances)
  {
    if(h < 0 || beam.size() == 0)
      return;
    Arrival arrival = {h, false, Least_distances::samples(beam), beam};
    widen(arrival, distances);
    if(!m_least.are_least(h, arrival.at, TOLERANCE) || is_dominated(h, arrival.at, distances))
      return;
    m_least.lower(h, arrival.at);
    m_queue.push((std::max)(arrival.at.front(), arrival.at.back()), arrival);
  }

  // A bend is removed if its source also sees the end of the side: around a vertex at which the
  // surface is flat, both paths have the same length. Otherwise, planes would not be exact.
  void widen(Arrival& arrival, const Eigen::VectorXd& distances)
  {
    Beam& beam = arrival.beam;
    const double length = beam.end(beam.size() - 1);
    const int size = beam.size();
    const double to_origin = distances[(*m_sides)[arrival.halfedge].origin],
                 to_target = distances[m_sides->target(arrival.halfedge)];
    while(beam.size() > 1 && beam[0].is_flat && !beam.is_earlier(0)
          && is_same(beam[1].distance(0., 0.), to_origin))
      beam.drop_front();
    while(beam.size() > 1 && beam[beam.size() - 1].is_flat && beam.is_earlier(beam.size() - 2)
          && is_same(beam[beam.size() - 2].distance(length, 0.), to_target))
      beam.drop_back();
    if(beam.size() < size)
      arrival.at = Least_distances::samples(beam);
  }

  static bool is_same(double d, double e) { return d >= e * (1 - SAME) && d <= e * (1 + SAME); }

  // Whether no shortest path crosses the side in this beam, since a path along the side to its far
  // end is shorter (Xin & Wang 2009).
  bool is_dominated(int h, const Arrival_queue::Samples& at, const Eigen::VectorXd& distances) const
  {
    const auto& side = (*m_sides)[h];
    return distances[side.origin] + side.length < at.back()
           || distances[m_sides->target(h)] + side.length < at.front();
  }

  // Propagates from one side of a face to its third corner and to the two other sides.
  void cross(const Arrival& arrival, Eigen::VectorXd& distances)
  {
    const int h = arrival.halfedge;
    const auto& side = (*m_sides)[h];
    const auto& next = (*m_sides)[Unfolded_sides::next(h)];
    const auto& previous = (*m_sides)[Unfolded_sides::previous(h)];
    const Beam_passage passage(arrival.beam, side.apex_x, side.apex_y,
                               m_sides->is_flat(side.origin), m_sides->is_flat(next.origin));
    const double over_left = arrival.at.front() + previous.length,
                 over_right = arrival.at.back() + next.length;
    if(!passage.is_hidden())
      lower_to(passage.straight(), previous.origin, false, distances);
    lower_to((std::min)(over_left, over_right), previous.origin, true, distances);

    const double over_end = passage.is_left() ? over_left : over_right;
    const double distance = distances[previous.origin];
    if(passage.is_hidden_by_flat() && !arrival.is_late
       && passage.straight() < distance * (1 - SAME))
    {
      put_off(arrival, over_end);
      return;
    }
    // beyond the corner, a bend is useful only if it is on the shortest path to the corner
    const bool turns = over_end <= distance * (1 + TOLERANCE);
    if(!passage.is_right() || turns)
      enter(next.twin, passage.over_next(m_sides->next_side(h)), distances);
    if(!passage.is_left() || turns)
      enter(previous.twin, passage.over_previous(m_sides->previous_side(h)), distances);
  }

  // Until then, the corner may be reached on the other side of a flat vertex, see `widen()`.
  void put_off(Arrival arrival, double time)
  {
    arrival.is_late = true;
    m_queue.push(time, arrival);
  }

  const Unfolded_sides* m_sides;
  Least_distances m_least;
  Arrival_queue m_queue;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> m_vertices;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_WAVEFRONT_H
