// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Edge_contraction.h"
#include "../surface/root_of_area.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// Contracts edges in passes over all vertices, with growing lengths, until about `number` vertices
// are left. In a triangulation where no edge is shorter than h, the mean area per vertex is about
// 1.6 h^2; thin parts keep more vertices.
inline void contract_to(Edge_contraction& contraction, const std::size_t number,
                        const double root_of_area)
{
  constexpr double area_per_vertex = 1.6, growth = 1.3, last_growth = 1.1;
  constexpr int most_last_passes = 30;
  const auto length = [&](const std::size_t n) {
    return root_of_area / std::sqrt(area_per_vertex * static_cast<double>(n));
  };
  double h = length(contraction.number_of_vertices());
  for(; h * growth < length(number); h *= growth)
    contraction.contract_edges(h, number);
  h = length(number);
  for(int pass = 0; contraction.number_of_vertices() > number && pass < most_last_passes;
      ++pass, h *= last_growth)
    contraction.contract_edges(h, number);
}

inline Coarse_surface_3 copied_surface(const Surface_component_3& surface)
{
  Coarse_surface_3 result;
  result.surface = surface;
  result.surface.caps.clear();
  result.surface.body_origins = surface.origins;
  result.vertices.resize(static_cast<std::size_t>(surface.points.rows()));
  std::iota(result.vertices.begin(), result.vertices.end(), std::size_t(0));
  return result;
}

inline Coarse_surface_3 remaining_surface(const Surface_component_3& surface,
                                          const Edge_contraction& contraction)
{
  Coarse_surface_3 result;
  std::vector<std::size_t> index(static_cast<std::size_t>(surface.points.rows()));
  for(std::size_t v = 0; v < index.size(); ++v)
    if(!contraction.is_removed(v))
    {
      index[v] = result.vertices.size();
      result.vertices.push_back(v);
    }
  for(std::size_t f = 0; f < surface.triangles.size(); ++f)
    if(!contraction.is_removed_triangle(f))
    {
      const auto& t = contraction.triangle(f);
      result.surface.triangles.push_back({index[static_cast<std::size_t>(t[0])],
                                          index[static_cast<std::size_t>(t[1])],
                                          index[static_cast<std::size_t>(t[2])]});
      result.surface.face_of_triangle.push_back(surface.face_of_triangle[f]);
    }
  result.surface.points = rows_at(surface.points, result.vertices);
  for(const std::size_t v : result.vertices)
    if(v < surface.origins.size())
      result.surface.origins.push_back(surface.origins[v]);
  result.surface.body_origins = result.surface.origins; // no body refers to it
  result.combinations.assign(contraction.combinations().rbegin(),
                             contraction.combinations().rend());
  return result;
}

} // namespace internal

Coarse_surface_3 coarse_surface(const Surface_component_3& surface,
                                const std::size_t number_of_vertices,
                                const std::vector<std::size_t>& kept)
{
  const auto n = static_cast<std::size_t>(surface.points.rows());
  for(const std::size_t v : kept)
    if(v >= n)
      throw std::invalid_argument("vertex " + std::to_string(v) + " is to be kept, but there are "
                                  + std::to_string(n));
  if(number_of_vertices >= n)
    return internal::copied_surface(surface);
  Point_matrix points = surface.points;
  internal::normalize(points);
  internal::Edge_contraction contraction(points, surface.triangles);
  for(const std::size_t v : kept)
    contraction.keep(v);
  internal::contract_to(contraction, (std::max)(number_of_vertices, std::size_t(1)),
                        internal::root_of_area(points, surface.triangles));
  return internal::remaining_surface(surface, contraction);
}

} // namespace Canonical_pose_3
} // namespace CGAL
