// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_HEAT_HEAT_LENGTHS_H
#define CANONICAL_POSE_3_ENGINE_HEAT_HEAT_LENGTHS_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Vertex_components.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/vertex_corners.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Calls f(vertex, length) for the other ends of the edges at `vertex`, twice for inner edges.
template <class Function>
void for_each_neighbor(const Intrinsic_triangulation& triangulation, const Buckets<int>& corners,
                       int vertex, const Function& f)
{
  for(const int h : corners[static_cast<std::size_t>(vertex)])
  {
    const int previous = Intrinsic_triangulation::previous(h);
    f(triangulation.target(h), triangulation.length(h));
    f(triangulation.origin(previous), triangulation.length(previous));
  }
}

// Returns the length of the longest path among those with the fewest edges from `source`; no
// shortest path is longer.
inline double fewest_edges_radius(const Intrinsic_triangulation& triangulation,
                                  const Buckets<int>& corners, int source,
                                  std::vector<double>& distances)
{
  std::vector<int> queue(1, source);
  distances[static_cast<std::size_t>(source)] = 0;
  double radius = 0;
  for(std::size_t i = 0; i < queue.size(); ++i)
  {
    const double distance = distances[static_cast<std::size_t>(queue[i])];
    radius = (std::max)(radius, distance);
    for_each_neighbor(triangulation, corners, queue[i], [&](int w, double length) {
      double& d = distances[static_cast<std::size_t>(w)];
      if(d != (std::numeric_limits<double>::infinity)())
        return;
      d = distance + length;
      queue.push_back(w);
    });
  }
  return radius;
}

// Returns the length of the longest of the shortest paths along edges from `source`. No two
// vertices of the component are farther apart on the surface than twice this length.
inline double edge_graph_radius(const Intrinsic_triangulation& triangulation,
                                const Buckets<int>& corners, int source)
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distances(triangulation.number_of_vertices(),
                                (std::numeric_limits<double>::infinity)());
  distances[static_cast<std::size_t>(source)] = 0;
  queue.emplace(0., source);
  double radius = 0;
  while(!queue.empty())
  {
    const auto [distance, v] = queue.top();
    queue.pop();
    if(distance > distances[static_cast<std::size_t>(v)])
      continue;
    radius = distance; // vertices are settled in increasing order
    for_each_neighbor(triangulation, corners, v, [&, d = distance](int w, double length) {
      if(d + length < distances[static_cast<std::size_t>(w)])
      {
        distances[static_cast<std::size_t>(w)] = d + length;
        queue.emplace(d + length, w);
      }
    });
  }
  return radius;
}

inline void check_time_step_factor(const double factor)
{
  if(factor > 0 && factor <= 1e6)
    return;
  std::ostringstream message;
  message << "the time step factor is " << factor << ", not positive and at most 1e6";
  throw std::invalid_argument(message.str());
}

// The length h of each component whose square is the time step: the mean edge length times the root
// of `time_step_factor`, but at least 1/300 of the radius of the edge graph. The heat decays at most
// like exp(-d/h), which underflows beyond d/h = 708 or so, and no two vertices are then farther
// apart than 600 h.
inline std::vector<double> heat_lengths(const Intrinsic_triangulation& triangulation,
                                        const Vertex_components& components,
                                        const double time_step_factor)
{
  auto lengths = triangulation.mean_edge_lengths(components.of_vertices(), components.size());
  for(double& length : lengths)
    length *= std::sqrt(time_step_factor);
  const Buckets<int> corners = vertex_corners(triangulation);
  std::vector<double> distances(triangulation.number_of_vertices(),
                                (std::numeric_limits<double>::infinity)());
  for(std::size_t c = 0; c < lengths.size(); ++c)
  {
    const int source = components.first_vertices()[c];
    if(fewest_edges_radius(triangulation, corners, source, distances) > 300 * lengths[c])
      lengths[c] = (std::max)(lengths[c], edge_graph_radius(triangulation, corners, source) / 300);
  }
  return lengths;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_HEAT_HEAT_LENGTHS_H
