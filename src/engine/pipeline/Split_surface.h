// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_SPLIT_SURFACE_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_SPLIT_SURFACE_H

#include "../surface/Edge_halving.h"
#include "../surface/root_of_area.h"

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A surface that was split where it is not manifold, and its vertices before that, the nodes, of
// which its vertices are copies. Long edges where it was split are halved, so that paths over them
// can go through nodes.
class Split_surface
{
public:
  explicit Split_surface(const Repaired_surface_3& surface)
    : points(surface.points), triangles(surface.triangles),
      face_of_triangle(surface.face_of_triangle),
      component_of_triangle(surface.component_of_triangle),
      m_number_of_originals(surface.origins.size()), m_node_of(surface.origins),
      m_copies(surface.representatives.size())
  {
    find_copies();
    if(!is_split())
      return;
    Edge_halving halving(points, triangles, {});
    const double shortest = root_of_area(points, triangles) / 32;
    while(2 * m_number_of_doors <= MOST_DOORS && halve(halving, shortest))
      find_copies();
    points = halving.points();
    triangles = halving.triangles();
    face_of_triangle.clear();
    component_of_triangle.clear();
    for(const std::size_t parent : halving.parents())
    {
      face_of_triangle.push_back(surface.face_of_triangle[parent]);
      component_of_triangle.push_back(surface.component_of_triangle[parent]);
    }
  }

  bool is_split() const { return !m_split_nodes.empty(); }

  // The doors: copies of nodes at which paths enter other sheets of the surface. If there are many,
  // only those of some nodes are returned, since the distances from all would take too long.
  std::vector<std::size_t> doors() const
  {
    std::vector<std::size_t> result;
    const std::size_t step = (m_number_of_doors + MOST_DOORS - 1) / MOST_DOORS;
    for(std::size_t i = 0; i < m_split_nodes.size(); i += step)
    {
      const std::vector<std::size_t>& copies = m_copies[m_split_nodes[i]];
      result.insert(result.end(), copies.begin(), copies.end());
    }
    return result;
  }

  // Extends the distances from a source to all sheets. `from_doors`: a column for each of doors().
  Eigen::VectorXd extended(Eigen::VectorXd distances, const Eigen::MatrixXd& from_doors) const
  {
    constexpr double tolerance = 1e-9;
    const std::vector<std::size_t> used = doors();
    std::vector<bool> is_done(used.size(), false);
    while(true)
    {
      std::size_t next = used.size();
      double least = (std::numeric_limits<double>::infinity)();
      for(std::size_t i = 0; i < used.size(); ++i)
        if(const double d = node_distance(distances, m_node_of[used[i]]); !is_done[i] && d < least)
        {
          least = d;
          next = i;
        }
      if(next == used.size())
        break;
      is_done[next] = true;
      if(distances[static_cast<Eigen::Index>(used[next])] > least * (1 + tolerance))
        distances = distances.cwiseMin(
          (from_doors.col(static_cast<Eigen::Index>(next)).array() + least).matrix());
    }
    if(used.size() < m_number_of_doors)
      go_along_edges(distances);
    for(Eigen::Index i = 0; i < distances.size(); ++i)
      distances[i] = node_distance(distances, m_node_of[static_cast<std::size_t>(i)]);
    return distances;
  }

  Point_matrix points;
  std::vector<Index_triangle> triangles;
  std::vector<std::size_t> face_of_triangle;
  std::vector<std::size_t> component_of_triangle;

private:
  static constexpr std::size_t MOST_DOORS = 128;

  using Pair = std::pair<std::size_t, std::size_t>;

  static Pair sorted(const std::size_t a, const std::size_t b)
  {
    return {(std::min)(a, b), (std::max)(a, b)};
  }

  void find_copies()
  {
    for(std::vector<std::size_t>& copies : m_copies)
      copies.clear();
    for(std::size_t i = 0; i < m_node_of.size(); ++i)
      m_copies[m_node_of[i]].push_back(i);
    m_split_nodes.clear();
    m_number_of_doors = 0;
    for(std::size_t node = 0; node < m_copies.size(); ++node)
      if(m_copies[node].size() > 1)
      {
        m_split_nodes.push_back(node);
        m_number_of_doors += m_copies[node].size();
      }
  }

  // Halves the longest edges, down to a length, along which the surface was split.
  bool halve(Edge_halving& halving, const double shortest)
  {
    std::map<Pair, std::set<Pair>> edges; // between nodes, and their copies
    for(const Index_triangle& t : halving.triangles())
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t a = t[k], b = t[(k + 1) % 3];
        if(m_copies[m_node_of[a]].size() > 1 && m_copies[m_node_of[b]].size() > 1)
          edges[sorted(m_node_of[a], m_node_of[b])].insert(sorted(a, b));
      }
    double longest = 0;
    std::map<Pair, std::size_t> middles; // the node of the middle of each edge
    for(const auto& edge : edges)
      if(edge.second.size() > 1)
      {
        const Pair& copy = *edge.second.begin();
        longest = (std::max)(longest, halving.length(copy.first, copy.second));
      }
    if(!(longest > shortest))
      return false;
    const std::size_t first = halving.number_of_vertices();
    halving.halve([&](const std::size_t a, const std::size_t b) {
      if(a >= first || b >= first)
        return false;
      const auto edge = edges.find(sorted(m_node_of[a], m_node_of[b]));
      return edge != edges.end() && edge->second.size() > 1 && halving.length(a, b) > longest * .51;
    });
    for(std::size_t i = first; i < halving.number_of_vertices(); ++i)
    {
      const auto& parents = halving.added()[i - m_number_of_originals].vertices;
      const auto found
        = middles.emplace(sorted(m_node_of[parents[0]], m_node_of[parents[1]]), m_copies.size());
      if(found.second)
        m_copies.emplace_back();
      m_node_of.push_back(found.first->second);
    }
    return true;
  }

  double node_distance(const Eigen::VectorXd& distances, const std::size_t node) const
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(const std::size_t copy : m_copies[node])
      least = (std::min)(least, distances[static_cast<Eigen::Index>(copy)]);
    return least;
  }

  // Decreases distances to those of paths that go on along edges.
  void go_along_edges(Eigen::VectorXd& distances) const
  {
    using Way = std::pair<double, std::size_t>;
    std::vector<std::vector<Way>> edges(m_copies.size());
    for(const Index_triangle& t : triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t a = t[k], b = t[(k + 1) % 3];
        const double length
          = (points.row(static_cast<Eigen::Index>(a)) - points.row(static_cast<Eigen::Index>(b)))
              .norm();
        edges[m_node_of[a]].emplace_back(length, m_node_of[b]);
        edges[m_node_of[b]].emplace_back(length, m_node_of[a]);
      }
    std::vector<double> least(m_copies.size());
    std::priority_queue<Way, std::vector<Way>, std::greater<Way>> reached;
    for(std::size_t node = 0; node < least.size(); ++node)
      reached.emplace(least[node] = node_distance(distances, node), node);
    while(!reached.empty())
    {
      const auto [distance, node] = reached.top();
      reached.pop();
      if(distance == least[node])
        for(const auto& [length, other] : edges[node])
          if(distance + length < least[other])
            reached.emplace(least[other] = distance + length, other);
    }
    for(std::size_t i = 0; i < m_node_of.size(); ++i)
      distances[static_cast<Eigen::Index>(i)] = least[m_node_of[i]];
  }

  const std::size_t m_number_of_originals;        // the first vertices
  std::vector<std::size_t> m_node_of;             // of each vertex
  std::vector<std::vector<std::size_t>> m_copies; // of each node
  std::vector<std::size_t> m_split_nodes;         // those with several copies
  std::size_t m_number_of_doors = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_SPLIT_SURFACE_H
