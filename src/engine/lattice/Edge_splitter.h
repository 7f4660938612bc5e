// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_EDGE_SPLITTER_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_EDGE_SPLITTER_H

#include "Surface_rays.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Splits edges at their midpoints until none is longer than `longest`. The shape of the surface
// does not change, even where it is not manifold: all faces of an edge share its midpoint.
class Edge_splitter
{
public:
  using Edge = std::pair<std::size_t, std::size_t>;

  Edge_splitter(Row_points& points, std::vector<Index_triangle>& triangles, const double longest)
    : m_longest(longest), m_number_of_vertices(static_cast<std::size_t>(points.rows()))
  {
    while(split_all(points, triangles))
      ;
  }

  // For each new vertex, the edge of which it is the midpoint; the endpoints of the edge have
  // smaller indices.
  const std::vector<Edge>& edges() const { return m_edges; }

private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  // Returns whether any edge was split.
  bool split_all(Row_points& points, std::vector<Index_triangle>& triangles)
  {
    if(std::none_of(triangles.begin(), triangles.end(), [&](const Index_triangle& t) {
         return is_long(t[0], t[1], points) || is_long(t[1], t[2], points)
                || is_long(t[2], t[0], points);
       }))
      return false;
    m_middles.clear();
    const std::size_t first = m_edges.size();
    std::vector<Index_triangle> parts;
    for(const Index_triangle& t : triangles)
      split(t, points, parts);
    triangles.swap(parts);
    points.conservativeResize(static_cast<Eigen::Index>(m_number_of_vertices + m_edges.size()), 3);
    for(std::size_t i = first; i < m_edges.size(); ++i)
      points.row(static_cast<Eigen::Index>(m_number_of_vertices + i))
        = (points.row(static_cast<Eigen::Index>(m_edges[i].first))
           + points.row(static_cast<Eigen::Index>(m_edges[i].second)))
          / 2;
    return true;
  }

  bool is_long(const std::size_t v, const std::size_t w, const Row_points& points) const
  {
    return (points.row(static_cast<Eigen::Index>(v)) - points.row(static_cast<Eigen::Index>(w)))
             .norm()
           > m_longest;
  }

  std::size_t middle(const std::size_t v, const std::size_t w, const Row_points& points)
  {
    if(!is_long(v, w, points))
      return NONE;
    const Edge edge = std::minmax(v, w);
    const auto [found, is_new] = m_middles.try_emplace(edge, m_number_of_vertices + m_edges.size());
    if(is_new)
      m_edges.push_back(edge);
    return found->second;
  }

  // Cuts off the corners between two midpoints; the rest has at most one midpoint.
  void split(Index_triangle t, const Row_points& points, std::vector<Index_triangle>& parts)
  {
    std::array<std::size_t, 3> m; // of the edge from corner k
    for(std::size_t k = 0; k < 3; ++k)
      m[k] = middle(t[k], t[(k + 1) % 3], points);
    const auto number = std::count(m.begin(), m.end(), NONE);
    if(number == 0)
    {
      for(std::size_t k = 0; k < 3; ++k)
        parts.push_back({t[k], m[k], m[(k + 2) % 3]});
      parts.push_back({m[0], m[1], m[2]});
      return;
    }
    // no edge has a midpoint, or only the edge from corner k
    std::size_t k = 0;
    while(number < 3 && (m[k] == NONE) != (number == 1))
      ++k;
    const std::size_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    if(number == 3)
      parts.push_back(t);
    else if(number == 2)
      parts.insert(parts.end(), {{a, m[k], c}, {m[k], b, c}});
    else
    {
      const std::size_t of_bc = m[(k + 1) % 3], of_ca = m[(k + 2) % 3];
      parts.insert(parts.end(), {{a, b, of_bc}, {a, of_bc, of_ca}, {of_ca, of_bc, c}});
    }
  }

  double m_longest;
  std::size_t m_number_of_vertices;
  std::vector<Edge> m_edges;
  std::unordered_map<Edge, std::size_t, boost::hash<Edge>> m_middles;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_EDGE_SPLITTER_H
