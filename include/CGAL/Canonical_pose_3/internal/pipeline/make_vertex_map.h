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
  const std::size_t n = map.representatives.size();
  map.component_of.assign(n, Vertex_map::NONE);
  map.local_of.assign(n, Vertex_map::NONE);
  for(std::size_t c = 0; c < components.size(); ++c)
    for(std::size_t i = 0; i < components[c].body_origins.size(); ++i)
    {
      const std::size_t v = components[c].body_origins[i];
      if(map.component_of[v] == Vertex_map::NONE)
      {
        map.component_of[v] = c;
        map.local_of[v] = i;
      }
      else if(map.component_of[v] != c)
        map.shared.push_back(v);
    }
  sort_and_make_unique(map.shared);
  for(std::size_t v = 0; v < n; ++v)
  {
    map.component_of[v] = map.component_of[map.representatives[v]];
    map.local_of[v] = map.local_of[map.representatives[v]];
    if(map.component_of[v] == Vertex_map::NONE)
      map.attached.push_back(v);
  }
}

// `others`: the vertices of each component that is not posed.
inline void find_rigid_parts(const std::vector<std::vector<std::size_t>>& others, Vertex_map& map)
{
  const std::size_t n = map.representatives.size();
  std::vector<std::size_t> part_of(n, Vertex_map::NONE);
  for(const std::vector<std::size_t>& vertices : others)
    if(!vertices.empty() && std::all_of(vertices.begin(), vertices.end(), [&](const std::size_t v) {
         return map.component_of[v] == Vertex_map::NONE;
       }))
    {
      for(const std::size_t v : vertices)
        part_of[v] = map.rigid_parts.size();
      map.rigid_parts.emplace_back();
    }
  for(std::size_t v = 0; v < n; ++v)
    if(part_of[map.representatives[v]] != Vertex_map::NONE)
      map.rigid_parts[part_of[map.representatives[v]]].push_back(v);
}

// The component nearest to each point.
inline std::vector<std::size_t>
nearest_components(const Point_matrix& points, const std::vector<Surface_component_3>& components)
{
  std::vector<std::size_t> result(static_cast<std::size_t>(points.rows()), 0);
  if(components.size() == 1 || result.empty())
    return result;
  std::vector<Index_triangle> triangles;
  std::vector<std::size_t> component_of_triangle;
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
      component_of_triangle.push_back(c);
    }
    n += components[c].points.rows();
  }
  const Triangle_tree tree(corners, triangles);
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = component_of_triangle
      [tree.nearest(tree.normalized(points.row(static_cast<Eigen::Index>(i)))).triangle];
  return result;
}

// Completes a map, given its first three members, except for the followers. `others`: the vertices
// of each component that is not posed.
inline Vertex_map make_vertex_map(Vertex_map map,
                                  const std::vector<Surface_component_3>& components,
                                  const std::vector<std::vector<std::size_t>>& others)
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
