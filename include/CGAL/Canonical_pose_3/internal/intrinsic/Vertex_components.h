// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_COMPONENTS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_COMPONENTS_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The connected components of the vertices, numbered in the order of their first vertices.
class Vertex_components
{
public:
  explicit Vertex_components(const Intrinsic_triangulation& triangulation)
    : m_component(triangulation.number_of_vertices())
  {
    std::vector<int> parent(m_component.size());
    for(std::size_t i = 0; i < parent.size(); ++i)
      parent[i] = static_cast<int>(i);
    const auto root = [&parent](int i) {
      for(auto k = static_cast<std::size_t>(i); parent[k] != i; k = static_cast<std::size_t>(i))
        i = parent[k] = parent[static_cast<std::size_t>(parent[k])];
      return i;
    };
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const int i = root(triangulation.origin(h)), j = root(triangulation.target(h));
      parent[static_cast<std::size_t>((std::max)(i, j))] = (std::min)(i, j);
    }
    for(std::size_t i = 0; i < parent.size(); ++i)
    {
      const int r = root(static_cast<int>(i));
      if(r == static_cast<int>(i))
        m_first_vertices.push_back(r);
      m_component[i]
        = r == static_cast<int>(i) ? size() - 1 : m_component[static_cast<std::size_t>(r)];
    }
  }

  int size() const { return static_cast<int>(m_first_vertices.size()); }
  const std::vector<int>& of_vertices() const { return m_component; }
  int operator[](Eigen::Index vertex) const
  {
    return m_component[static_cast<std::size_t>(vertex)];
  }
  const std::vector<int>& first_vertices() const { return m_first_vertices; }

private:
  std::vector<int> m_component;
  std::vector<int> m_first_vertices;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_COMPONENTS_H
