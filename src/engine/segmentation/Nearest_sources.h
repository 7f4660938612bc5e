// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_NEAREST_SOURCES_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_NEAREST_SOURCES_H

#include "Face_graph.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// For each face, the distance to the nearest source and its label, by shortest paths on the graph.
class Nearest_sources
{
public:
  // `lengths`: one per edge. Faces at `limit` and beyond are not reached, and have the label 0.
  Nearest_sources(const Face_graph& graph, std::vector<double> lengths,
                  const double limit = std::numeric_limits<double>::infinity())
    : m_graph(graph), m_lengths(std::move(lengths)), m_distances(graph.number_of_faces(), limit),
      m_labels(graph.number_of_faces(), 0)
  {}

  void insert(const std::size_t face, const std::size_t label) { reach(face, 0, label); }

  // Updates the distances and labels for the sources inserted since the last call.
  void update()
  {
    while(!m_queue.empty())
    {
      const auto [distance, face] = m_queue.top();
      m_queue.pop();
      if(distance == m_distances[face])
        for(const Face_graph::Neighbor& neighbor : m_graph.neighbors[face])
          reach(neighbor.face, distance + m_lengths[neighbor.edge], m_labels[face]);
    }
  }

  const std::vector<double>& distances() const { return m_distances; }
  const std::vector<std::size_t>& labels() const { return m_labels; }

private:
  using Entry = std::pair<double, std::size_t>; // distance and face

  void reach(const std::size_t face, const double distance, const std::size_t label)
  {
    if(distance < m_distances[face])
    {
      m_distances[face] = distance;
      m_labels[face] = label;
      m_queue.emplace(distance, face);
    }
  }

  const Face_graph& m_graph;
  const std::vector<double> m_lengths;
  std::vector<double> m_distances;
  std::vector<std::size_t> m_labels;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_NEAREST_SOURCES_H
