// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_EDGE_HALVING_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_EDGE_HALVING_H

#include <CGAL/Canonical_pose_3/Vertex_combination_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Triangles whose edges are halved, in passes. The surface remains the same, and its new vertices do
// not depend on the order of the triangles.
class Edge_halving
{
public:
  // `caps`: further triangles, of which only the edges that are also edges of `triangles` are halved.
  Edge_halving(const Point_matrix& points, std::vector<Index_triangle> triangles,
               std::vector<Index_triangle> caps)
    : m_triangles(std::move(triangles)), m_caps(std::move(caps))
  {
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      m_points.push_back(points.row(i));
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      m_parents.push_back(t);
  }

  // Halves the edges between vertices a and b for which is_long(a, b); returns whether there are any.
  template <class Function>
  bool halve(const Function& is_long)
  {
    m_middles.clear();
    for(const Index_triangle& t : m_triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t a = t[k], b = t[(k + 1) % 3];
        if(is_long(a, b) && m_middles.emplace(key(a, b), m_points.size()).second)
        {
          m_added.push_back({m_points.size(), {a, b, b}, {.5, .5, 0}});
          m_points.push_back(.5 * (m_points[a] + m_points[b]));
        }
      }
    if(m_middles.empty())
      return false;
    std::vector<std::size_t> parents, ignored;
    m_triangles = pieces(m_triangles, parents);
    for(std::size_t& parent : parents)
      parent = m_parents[parent];
    m_parents = std::move(parents);
    m_caps = pieces(m_caps, ignored);
    return true;
  }

  double length(const std::size_t a, const std::size_t b) const
  {
    return (m_points[a] - m_points[b]).norm();
  }

  std::size_t number_of_vertices() const { return m_points.size(); }
  const std::vector<Index_triangle>& triangles() const { return m_triangles; }
  const std::vector<Index_triangle>& caps() const { return m_caps; }
  // The original triangle that contains each triangle.
  const std::vector<std::size_t>& parents() const { return m_parents; }
  // The new vertices, which follow the original ones.
  const std::vector<Vertex_combination_3>& added() const { return m_added; }

  Point_matrix points() const
  {
    Point_matrix result(static_cast<Eigen::Index>(m_points.size()), 3);
    for(std::size_t i = 0; i < m_points.size(); ++i)
      result.row(static_cast<Eigen::Index>(i)) = m_points[i];
    return result;
  }

private:
  static constexpr std::size_t NONE = std::size_t(-1);

  static std::pair<std::size_t, std::size_t> key(const std::size_t a, const std::size_t b)
  {
    return {(std::min)(a, b), (std::max)(a, b)};
  }

  std::size_t middle(const std::size_t a, const std::size_t b) const
  {
    const auto found = m_middles.find(key(a, b));
    return found == m_middles.end() ? NONE : found->second;
  }

  // The pieces of all triangles, and the triangle to which each belongs.
  std::vector<Index_triangle> pieces(const std::vector<Index_triangle>& triangles,
                                     std::vector<std::size_t>& parents) const
  {
    std::vector<Index_triangle> result;
    for(std::size_t i = 0; i < triangles.size(); ++i)
    {
      split(triangles[i], result);
      parents.resize(result.size(), i);
    }
    return result;
  }

  void split(const Index_triangle& t, std::vector<Index_triangle>& result) const
  {
    std::array<std::size_t, 3> middles;
    for(std::size_t k = 0; k < 3; ++k)
      middles[k] = middle(t[k], t[(k + 1) % 3]);
    const auto number = 3 - std::count(middles.begin(), middles.end(), NONE);
    if(number == 0)
    {
      result.push_back(t);
      return;
    }
    // the first edge is the only one that is halved, or the only one that is not
    std::size_t first = 0;
    while(number < 3 && (middles[first] == NONE) != (number == 2))
      ++first;
    const std::size_t a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
    const std::size_t ab = middles[first], bc = middles[(first + 1) % 3],
                      ca = middles[(first + 2) % 3];
    if(number == 3)
      result.insert(result.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    else if(number == 1)
      result.insert(result.end(), {{a, ab, c}, {ab, b, c}});
    else if(length(a, bc) <= length(b, ca))
      result.insert(result.end(), {{ca, bc, c}, {a, b, bc}, {a, bc, ca}});
    else
      result.insert(result.end(), {{ca, bc, c}, {a, b, ca}, {b, bc, ca}});
  }

  std::vector<Eigen::RowVector3d> m_points;
  std::vector<Index_triangle> m_triangles, m_caps;
  std::vector<std::size_t> m_parents;
  std::vector<Vertex_combination_3> m_added;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_middles; // of this pass
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_EDGE_HALVING_H
