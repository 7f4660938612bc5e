// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_MAKE_VERTEX_MAP_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_MAKE_VERTEX_MAP_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/soup/Triangle_tree.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// A vertex of several components belongs to the largest one. A stitched vertex belongs to the
// component of the vertex to which it was stitched.
inline void locate_vertices(const std::vector<Surface_component_3>& components, Vertex_map& map)
{
  const std::size_t n = map.number_of_vertices();
  map.component_of = Indexed_vector<Vertex_index, Component_index>(n, Component_index::NONE);
  map.local_of = Indexed_vector<Vertex_index, std::size_t>(n);
  map.component_of_row
    = Indexed_vector<Row_index, Component_index>(map.number_of_rows(), Component_index::NONE);
  for(std::size_t number = 0; number < components.size(); ++number)
  {
    const auto c = Component_index(number);
    for(std::size_t i = 0; i < components[number].body_origins.size(); ++i)
    {
      const Vertex_index v = vertex_of(components[number], i);
      if(map.component_of[v] == Component_index::NONE)
      {
        map.component_of[v] = c;
        map.local_of[v] = i;
      }
      else if(map.component_of[v] != c)
        map.shared.push_back(v);
    }
    for(std::size_t i = 0; i < components[number].origins.size(); ++i)
      if(Component_index& of_row = map.component_of_row[row_of(components[number], i)];
         of_row == Component_index::NONE)
        of_row = c;
  }
  sort_and_make_unique(map.shared);
  map.representatives.for_each_index([&](const Vertex_index v) {
    map.component_of[v] = map.component_of[map.representatives[v]];
    map.local_of[v] = map.local_of[map.representatives[v]];
    if(map.component_of[v] == Component_index::NONE)
      map.attached.push_back(v);
  });
}

// `others`: the vertices of each component that is not posed.
inline void find_rigid_parts(const std::vector<std::vector<Vertex_index>>& others, Vertex_map& map)
{
  constexpr std::size_t none = std::size_t(-1);
  Indexed_vector<Vertex_index, std::size_t> part_of(map.number_of_vertices(), none);
  for(const std::vector<Vertex_index>& vertices : others)
    if(!vertices.empty() && std::all_of(vertices.begin(), vertices.end(), [&](const Vertex_index v) {
         return map.component_of[v] == Component_index::NONE;
       }))
    {
      for(const Vertex_index v : vertices)
        part_of[v] = map.rigid_parts.size();
      map.rigid_parts.emplace_back();
    }
  map.representatives.for_each_index([&](const Vertex_index v) {
    if(part_of[map.representatives[v]] != none)
      map.rigid_parts[part_of[map.representatives[v]]].push_back(v);
  });
}

// The component nearest to each point.
inline std::vector<Component_index>
nearest_components(const Point_matrix& points, const std::vector<Surface_component_3>& components)
{
  std::vector<Component_index> result(static_cast<std::size_t>(points.rows()), Component_index(0));
  if(components.size() == 1 || result.empty())
    return result;
  std::vector<Index_triangle> triangles;
  std::vector<Component_index> component_of_triangle;
  Eigen::Index n = 0;
  for(const Surface_component_3& component : components)
    n += component.points.rows();
  Point_matrix corners(n, 3);
  n = 0;
  for(std::size_t c = 0; c < components.size(); ++c)
  {
    corners.middleRows(n, components[c].points.rows()) = components[c].points;
    for(Index_triangle t : components[c].triangles)
    {
      for(std::size_t& v : t)
        v += static_cast<std::size_t>(n);
      triangles.push_back(t);
      component_of_triangle.push_back(Component_index(c));
    }
    n += components[c].points.rows();
  }
  const Triangle_tree tree(corners, triangles);
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = component_of_triangle
      [tree.nearest(tree.normalized(points.row(static_cast<Eigen::Index>(i)))).triangle];
  return result;
}

// Completes a map, given its first four members, except for the followers. `others`: the vertices
// of each component that is not posed.
inline Vertex_map make_vertex_map(Vertex_map map,
                                  const std::vector<Surface_component_3>& components,
                                  const std::vector<std::vector<Vertex_index>>& others)
{
  locate_vertices(components, map);
  find_rigid_parts(others, map);
  return map;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_MAKE_VERTEX_MAP_H
