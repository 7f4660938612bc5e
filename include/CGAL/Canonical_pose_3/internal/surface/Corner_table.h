// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CORNER_TABLE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CORNER_TABLE_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
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
  using Index = Face_list::Index;

  static constexpr Index NONE = Index(-1); // neither a corner nor a side

  // Sides with the same two ends, in order.
  using Edge = boost::iterator_range<const Index*>;

  Corner_table(const std::size_t number_of_vertices, Face_list faces) : m_faces(std::move(faces))
  {
    check_number_of_corners(number_of_corners());
    if(!m_faces.are_triangles())
    {
      m_face.reserve(number_of_corners());
      for(std::size_t f = 0; f < m_faces.size(); ++f)
        m_face.resize(m_faces.begin_of_face(f + 1), static_cast<Index>(f));
    }
    sort_sides(number_of_vertices);
  }

  // Throws std::invalid_argument if corners cannot be numbered.
  static void check_number_of_corners(const std::size_t n)
  {
    if(n > (std::numeric_limits<Index>::max)())
      throw std::invalid_argument("the faces have " + std::to_string(n)
                                  + " corners, but there can be at most 4294967295");
  }

  std::size_t number_of_corners() const { return m_faces.vertices().size(); }
  std::size_t vertex(const std::size_t c) const { return m_faces.vertices()[c]; }
  std::size_t face(const std::size_t c) const { return m_face.empty() ? c / 3 : m_face[c]; }
  std::size_t next(const std::size_t c) const
  {
    if(m_face.empty())
      return c % 3 == 2 ? c - 2 : c + 1;
    return c + 1 == m_faces.begin_of_face(m_face[c] + 1) ? m_faces.begin_of_face(m_face[c]) : c + 1;
  }
  std::size_t target(const std::size_t c) const { return vertex(next(c)); }
  // Returns the smaller and the larger end of side c.
  std::pair<std::size_t, std::size_t> ends(const std::size_t c) const
  {
    return std::minmax({vertex(c), target(c)});
  }
  // Returns the corner of v, an end of side c.
  std::size_t corner_of_end(const std::size_t c, const std::size_t v) const
  {
    return vertex(c) == v ? c : next(c);
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
    using End_and_side = std::pair<Index, Index>; // the larger end
    const auto sides_of_smaller_ends = Buckets<End_and_side>::sorted(
      number_of_vertices, number_of_corners(), [&](const std::size_t c, const auto& put) {
        if(const auto [smaller, larger] = ends(c); smaller != larger)
          put(smaller, End_and_side(static_cast<Index>(larger), static_cast<Index>(c)));
      });
    m_sides.reserve(sides_of_smaller_ends.values().size());
    for(std::size_t v = 0; v < number_of_vertices; ++v)
    {
      const auto around = sides_of_smaller_ends[v];
      for(auto it = around.begin(); it != around.end(); ++it)
      {
        if(it == around.begin() || it->first != (it - 1)->first)
          m_first_of_edge.push_back(static_cast<Index>(m_sides.size()));
        m_sides.push_back(it->second);
      }
    }
    m_first_of_edge.push_back(static_cast<Index>(m_sides.size()));
  }

  Face_list m_faces;
  std::vector<Index> m_face;                   // of each corner, unless all are triangles
  std::vector<Index> m_sides, m_first_of_edge; // edge by edge
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CORNER_TABLE_H
