// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_MAKE_VERTEX_MAP_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_MAKE_VERTEX_MAP_H

#include "component_roles.h"
#include "joined_triangles.h"

#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_tree.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
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

// The component nearest to a point, and its distance.
struct Nearest_component
{
  Component_index component = Component_index(0);
  double distance = 0;
};

inline std::vector<Nearest_component>
nearest_components(const Point_matrix& points, const std::vector<Surface_component_3>& components)
{
  std::vector<std::size_t> all(components.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  const Joined_triangles joined = joined_triangles(components, all);
  const Triangle_tree tree(joined.points, joined.triangles);
  std::vector<Nearest_component> result(static_cast<std::size_t>(points.rows()));
  for_each_block(result.size(), [&](std::size_t, const std::size_t begin, const std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
    {
      const Eigen::RowVector3d point = points.row(static_cast<Eigen::Index>(i));
      const std::size_t triangle = tree.nearest(tree.normalized(point)).triangle;
      result[i] = {Component_index(joined.component_of_triangle[triangle]), tree.distance(point)};
    }
  });
  return result;
}

// A component without a pose.
struct Other_component
{
  std::size_t number; // among all components
  std::vector<std::size_t> vertices;
  Component_role role;
};

// See `Rigid_part`. Where nothing is near, all vertices count.
inline std::vector<double> weights_of_nearness(const Point_matrix& points,
                                               const std::vector<double>& distances)
{
  constexpr double closeness = .1; // of the radius
  const Eigen::RowVector3d center = points.colwise().mean();
  const double unit = closeness * (points.rowwise() - center).rowwise().norm().maxCoeff();
  std::vector<double> result(distances.size(), 1);
  if(unit > 0 && *std::min_element(distances.begin(), distances.end()) <= unit)
    std::transform(distances.begin(), distances.end(), result.begin(), [&](const double distance) {
      return std::pow(1 + std::pow(distance / unit, 2), -2);
    });
  return result;
}

// `part`: indices of attached vertices.
inline Rigid_part rigid_part(const std::vector<std::size_t>& part, const Point_matrix& points,
                             const std::vector<Vertex_index>& attached,
                             const std::vector<Nearest_component>& nearest)
{
  Rigid_part result;
  std::vector<double> distances;
  for(const std::size_t i : part)
  {
    result.vertices.push_back(attached[i]);
    distances.push_back(nearest[i].distance);
  }
  result.weights
    = weights_of_nearness(rows_at(rows_by<Vertex_index>(points), result.vertices), distances);
  return result;
}

// Lets each component without a pose follow one component, that which it touches, or that to which
// most of its vertices are nearest. `posed`: the numbers of the components of the map. `nearest`: the
// components that the attached vertices follow, which are changed accordingly.
inline std::vector<Registration_summary::Follower>
follow_components(const std::vector<Other_component>& others, const std::vector<std::size_t>& posed,
                  const Point_matrix& points, Vertex_map& map,
                  std::vector<Nearest_component>& nearest)
{
  const std::size_t none = others.size();
  Indexed_vector<Vertex_index, std::size_t> other_of(map.number_of_vertices(), none);
  for(std::size_t o = others.size(); o-- > 0;)
    for(const std::size_t v : others[o].vertices)
      other_of[Vertex_index(v)] = o;
  std::vector<std::vector<std::size_t>> attached_of(others.size());
  for(std::size_t i = 0; i < map.attached.size(); ++i)
    if(const std::size_t o = other_of[map.representatives[map.attached[i]]]; o != none)
      attached_of[o].push_back(i);

  std::vector<Registration_summary::Follower> result;
  std::map<std::pair<std::size_t, Component_index>, std::vector<std::size_t>> parts; // by group
  for(std::size_t o = 0; o < others.size(); ++o)
  {
    const auto& [number, vertices, role] = others[o];
    if(vertices.empty())
      continue;
    const auto touching = std::find_if(vertices.begin(), vertices.end(), [&](const std::size_t v) {
      return map.component_of[Vertex_index(v)] != Component_index::NONE;
    });
    const bool is_loose = touching == vertices.end();
    Component_index leader = Component_index(0);
    if(!is_loose)
      leader = map.component_of[Vertex_index(*touching)];
    else
    {
      std::vector<std::size_t> votes(posed.size(), 0);
      for(const std::size_t i : attached_of[o])
        ++votes[static_cast<std::size_t>(nearest[i].component)];
      leader = Component_index(std::max_element(votes.begin(), votes.end()) - votes.begin());
    }
    const bool is_fixed = is_loose && role.kind == Component_role::FIXED;
    const bool is_rigid = is_loose && role.kind != Component_role::DEFORMED;
    for(const std::size_t i : attached_of[o])
    {
      nearest[i].component = leader;
      if(is_fixed)
        map.fixed.push_back(map.attached[i]);
      else if(is_rigid)
        parts[{role.group, leader}].push_back(i);
    }
    result.push_back({number, *std::min_element(vertices.begin(), vertices.end()),
                      is_fixed ? number : posed[static_cast<std::size_t>(leader)], is_rigid});
  }
  for(const auto& part : parts)
    map.rigid_parts.push_back(rigid_part(part.second, points, map.attached, nearest));
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_MAKE_VERTEX_MAP_H
