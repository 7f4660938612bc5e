// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_COMPONENTS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_COMPONENTS_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The connected components of the vertices, numbered in the order of their first vertices.
class Vertex_components
{
public:
  explicit Vertex_components(const Intrinsic_triangulation& triangulation)
  {
    Disjoint_sets sets(triangulation.number_of_vertices());
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
      sets.unite(static_cast<std::size_t>(triangulation.origin(h)),
                 static_cast<std::size_t>(triangulation.target(h)));
    const Component_labels labels = label_components(sets);
    m_component.assign(labels.of_items.begin(), labels.of_items.end());
    m_first_vertices.assign(labels.first_items.begin(), labels.first_items.end());
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_VERTEX_COMPONENTS_H
