// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CORNER_TABLE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CORNER_TABLE_H

#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The corners of polygons, numbered face by face, and their edges. Side c runs from the vertex of
// corner c to that of the next corner of the face.
class Corner_table
{
public:
  static constexpr std::size_t NONE = std::size_t(-1); // neither a corner nor a side

  // Sides with the same two ends, in order.
  using Edge = boost::iterator_range<const std::size_t*>;

  template <class Polygons>
  Corner_table(const std::size_t number_of_vertices, const Polygons& polygons)
  {
    m_first.reserve(polygons.size() + 1);
    for(const auto& polygon : polygons)
    {
      m_first.push_back(m_vertex.size());
      m_vertex.insert(m_vertex.end(), polygon.begin(), polygon.end());
      m_face.resize(m_vertex.size(), m_first.size() - 1);
    }
    m_first.push_back(m_vertex.size());
    sort_sides(number_of_vertices);
  }

  std::size_t number_of_corners() const { return m_vertex.size(); }
  std::size_t vertex(const std::size_t c) const { return m_vertex[c]; }
  std::size_t face(const std::size_t c) const { return m_face[c]; }
  std::size_t next(const std::size_t c) const
  {
    return c + 1 == m_first[m_face[c] + 1] ? m_first[m_face[c]] : c + 1;
  }
  std::size_t target(const std::size_t c) const { return m_vertex[next(c)]; }
  // Returns the smaller and the larger end of side c.
  std::pair<std::size_t, std::size_t> ends(const std::size_t c) const
  {
    return std::minmax({m_vertex[c], target(c)});
  }
  // Returns the corner of v, an end of side c.
  std::size_t corner_of_end(const std::size_t c, const std::size_t v) const
  {
    return m_vertex[c] == v ? c : next(c);
  }

  // Calls f(edge) for each edge, sorted by its smaller end, then by its larger one. Sides from a
  // vertex to itself are skipped.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for(std::size_t e = 1; e < m_first_of_edge.size(); ++e)
      f(Edge(m_sides.data() + m_first_of_edge[e - 1], m_sides.data() + m_first_of_edge[e]));
  }

private:
  void sort_sides(const std::size_t number_of_vertices)
  {
    using End_and_side = std::pair<std::size_t, std::size_t>; // the larger end
    Buckets<End_and_side> sides_of_smaller_ends(number_of_vertices, [&](const auto& put) {
      for(std::size_t c = 0; c < m_vertex.size(); ++c)
        if(m_vertex[c] != target(c))
          put(ends(c).first, End_and_side(ends(c).second, c));
    });
    m_sides.reserve(sides_of_smaller_ends.values().size());
    for(std::size_t v = 0; v < number_of_vertices; ++v)
    {
      const auto around = sides_of_smaller_ends[v];
      std::sort(around.begin(), around.end());
      for(auto it = around.begin(); it != around.end(); ++it)
      {
        if(it == around.begin() || it->first != (it - 1)->first)
          m_first_of_edge.push_back(m_sides.size());
        m_sides.push_back(it->second);
      }
    }
    m_first_of_edge.push_back(m_sides.size());
  }

  std::vector<std::size_t> m_first, m_vertex, m_face;
  std::vector<std::size_t> m_sides, m_first_of_edge; // edge by edge
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CORNER_TABLE_H
