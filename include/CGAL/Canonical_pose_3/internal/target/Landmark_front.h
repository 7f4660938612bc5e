// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_LANDMARK_FRONT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_LANDMARK_FRONT_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/vertex_corners.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Fronts that propagate from one source after the other, each as long as it decreases the distance
// to the nearest source. They propagate along edges, and through faces from two reached corners,
// assuming that the source is straight behind the edge between them (Novotni & Klein 2002).
// Distances approximate those on the surface, well enough to compare vertices.
class Landmark_front
{
public:
  // `triangulation`, which should be Delaunay, must outlive this object.
  explicit Landmark_front(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation), m_corners(vertex_corners(triangulation)),
      m_vertices(triangulation.number_of_vertices())
  {
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
      m_apices.push_back(triangulation.apex(h));
  }

  // Decreases `nearest`, one number per vertex, to the distances from `source` if these are
  // smaller.
  void lower(Eigen::Index source, Eigen::VectorXd& nearest)
  {
    ++m_front;
    offer(static_cast<int>(source), 0.);
    while(!m_queue.empty())
    {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      Vertex& vertex = at(v);
      if(vertex.settled_by == m_front)
        continue;
      vertex.settled_by = m_front;
      vertex.is_lower = distance < nearest[v];
      if(vertex.is_lower)
        nearest[v] = distance;
      for(const int h : m_corners[static_cast<std::size_t>(v)])
      {
        const int previous = Intrinsic_triangulation::previous(h);
        if(vertex.is_lower)
        {
          offer(m_triangulation.target(h), distance + m_triangulation.length(h));
          offer(m_triangulation.origin(previous), distance + m_triangulation.length(previous));
        }
        cross(h, m_triangulation.origin(previous));
        cross(previous, m_triangulation.target(h));
      }
    }
  }

private:
  struct Vertex
  {
    double distance = 0; // of the last front that reached it
    int reached_by = 0, settled_by = 0;
    bool is_lower = false;
  };

  Vertex& at(int v) { return m_vertices[static_cast<std::size_t>(v)]; }

  void offer(int v, double distance)
  {
    Vertex& vertex = at(v);
    if(vertex.settled_by == m_front
       || (vertex.reached_by == m_front && vertex.distance <= distance))
      return;
    vertex.reached_by = m_front;
    vertex.distance = distance;
    m_queue.emplace(distance, v);
  }

  // Propagates from both ends of halfedge `h` to the third corner `v` of its face.
  void cross(int h, int v)
  {
    const Vertex &from = at(m_triangulation.origin(h)), &to = at(m_triangulation.target(h));
    if(from.settled_by != m_front || to.settled_by != m_front || !(from.is_lower || to.is_lower)
       || at(v).settled_by == m_front)
      return;
    const double length = m_triangulation.length(h);
    const double x
      = 0.5 * (length + (from.distance - to.distance) / length * (from.distance + to.distance));
    const double square = (from.distance - x) * (from.distance + x);
    if(!(square >= 0))
      return;
    const double depth = std::sqrt(square);
    const auto [apex_x, height] = m_apices[static_cast<std::size_t>(h)];
    const double crossing = x * height + apex_x * depth; // times depth + height
    if(crossing >= 0 && crossing <= length * (depth + height))
      offer(v, std::hypot(apex_x - x, height + depth));
  }

  using Entry = std::pair<double, int>;

  const Intrinsic_triangulation& m_triangulation;
  Buckets<int> m_corners;
  std::vector<std::pair<double, double>> m_apices; // of the faces above their halfedges
  std::vector<Vertex> m_vertices;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
  int m_front = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_LANDMARK_FRONT_H
