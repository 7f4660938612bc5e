// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SELECTED_COMPONENTS_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SELECTED_COMPONENTS_H

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A value for each row.
inline std::vector<std::size_t> components_of_rows(const Repaired_surface_3& surface)
{
  std::vector<std::size_t> result(surface.origins.size());
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    for(const std::size_t v : surface.triangles[t])
      result[v] = surface.component_of_triangle[t];
  return result;
}

// Those components with their vertices and caps, in the same order.
inline Repaired_surface_3 selected_components(const Repaired_surface_3& surface,
                                              const std::vector<bool>& is_selected)
{
  Repaired_surface_3 result;
  result.representatives = surface.representatives;
  const std::vector<std::size_t> components = components_of_rows(surface);
  std::vector<std::size_t> rows, number(components.size()), number_of_component(is_selected.size());
  for(std::size_t v = 0; v < components.size(); ++v)
    if(is_selected[components[v]])
    {
      number[v] = rows.size();
      rows.push_back(v);
      result.origins.push_back(surface.origins[v]);
    }
  result.points = rows_at(surface.points, rows);
  for(std::size_t c = 0; c < is_selected.size(); ++c)
    if(is_selected[c])
      number_of_component[c] = result.number_of_components++;
  const auto renumbered = [&](std::array<std::size_t, 3> triangle) {
    for(std::size_t& v : triangle)
      v = number[v];
    return triangle;
  };
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    if(const std::size_t c = surface.component_of_triangle[t]; is_selected[c])
    {
      result.triangles.push_back(renumbered(surface.triangles[t]));
      result.face_of_triangle.push_back(surface.face_of_triangle[t]);
      result.component_of_triangle.push_back(number_of_component[c]);
    }
  for(const std::array<std::size_t, 3>& cap : surface.caps)
    if(is_selected[components[cap[0]]])
      result.caps.push_back(renumbered(cap));
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SELECTED_COMPONENTS_H
