// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_VERTEX_CORNERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_VERTEX_CORNERS_H

#include <CGAL/Canonical_pose_3/internal/Intrinsic_triangulation.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The corners of the faces around each vertex, that is, the halfedges with this origin. Across them,
// along `next` and `previous`, lie all of its neighbours, also at the border.
class Vertex_corners
{
public:
  explicit Vertex_corners(const Intrinsic_triangulation& triangulation)
    : m_end(triangulation.number_of_vertices() + 1, 0),
      m_halfedges(static_cast<std::size_t>(triangulation.number_of_halfedges()))
  {
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
      ++m_end[static_cast<std::size_t>(triangulation.origin(h))];
    std::size_t sum = 0;
    for(std::size_t& end : m_end)
      sum += std::exchange(end, sum);
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
      m_halfedges[m_end[static_cast<std::size_t>(triangulation.origin(h))]++] = h;
  }

  const int* begin(int vertex) const
  {
    return m_halfedges.data() + (vertex == 0 ? 0 : m_end[static_cast<std::size_t>(vertex) - 1]);
  }
  const int* end(int vertex) const
  {
    return m_halfedges.data() + m_end[static_cast<std::size_t>(vertex)];
  }

private:
  std::vector<std::size_t> m_end;
  std::vector<int> m_halfedges;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_VERTEX_CORNERS_H
