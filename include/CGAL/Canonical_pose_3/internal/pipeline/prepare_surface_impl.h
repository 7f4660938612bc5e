// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_PREPARE_SURFACE_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_PREPARE_SURFACE_IMPL_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/cut_contacts.h>
#include <CGAL/Canonical_pose_3/internal/support/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/component_options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/fragments.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/soup/examine_surface.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

namespace internal {

// Polygons with the smallest corner first, like those of `index_polygons()`: so a soup and a mesh have
// the same pose, bit for bit.
inline std::vector<std::vector<std::size_t>>
with_smallest_corners_first(std::vector<std::vector<std::size_t>> polygons)
{
  for(std::vector<std::size_t>& corners : polygons)
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return polygons;
}

// The components with the given indices of a surface, in one pass over it.
inline std::vector<Surface_component_3>
components_of_indices(const Repaired_surface_3& surface, const std::vector<std::size_t>& indices)
{
  const std::size_t none = indices.size();
  std::vector<std::size_t> position(surface.number_of_components, none);
  for(std::size_t c = 0; c < indices.size(); ++c)
    position[indices[c]] = c;

  std::vector<Surface_component_3> result(indices.size());
  std::vector<std::size_t> component_of_vertex(surface.origins.size(), none);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::size_t c = position[surface.component_of_triangle[t]];
    if(c == none)
      continue;
    result[c].triangles.push_back(surface.triangles[t]);
    result[c].face_of_triangle.push_back(surface.face_of_triangle[t]);
    for(const std::size_t v : surface.triangles[t])
      component_of_vertex[v] = c;
  }
  for(const auto& cap : surface.caps)
    if(component_of_vertex[cap[0]] != none)
      result[component_of_vertex[cap[0]]].caps.push_back(cap);

  std::vector<std::size_t> number(surface.origins.size());
  std::vector<std::vector<std::size_t>> vertices(indices.size());
  for(std::size_t v = 0; v < number.size(); ++v)
    if(component_of_vertex[v] != none)
    {
      number[v] = vertices[component_of_vertex[v]].size();
      vertices[component_of_vertex[v]].push_back(v);
    }
  for(std::size_t c = 0; c < result.size(); ++c)
  {
    result[c].points = rows_at(surface.points, vertices[c]);
    for(const std::size_t v : vertices[c])
      result[c].origins.push_back(surface.origins[v]);
    result[c].body_origins = result[c].origins;
    for(auto* const triangles : {&result[c].triangles, &result[c].caps})
      for(Index_triangle& t : *triangles)
        for(std::size_t& v : t)
          v = number[v];
  }
  return result;
}

// The vertices of each component that is not to be posed.
inline std::vector<std::vector<Vertex_index>>
vertices_of_others(const Repaired_surface_3& surface, const std::vector<std::size_t>& posed)
{
  std::vector<std::vector<Vertex_index>> result(surface.number_of_components);
  std::vector<bool> is_posed(surface.number_of_components, false);
  for(const std::size_t c : posed)
    is_posed[c] = true;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    if(!is_posed[surface.component_of_triangle[t]])
      for(const std::size_t v : surface.triangles[t])
        result[surface.component_of_triangle[t]].push_back(Vertex_index(surface.origins[v]));
  return result;
}

// The components that have an area and are not fragments of another one after splitting.
inline std::vector<std::size_t> components_to_pose(const Repaired_surface_3& surface,
                                                   const Diagnosis_3& diagnosis,
                                                   const Options::Components components)
{
  const std::size_t n = surface.number_of_components;
  std::vector<double> areas(n, 0.);
  std::vector<std::vector<std::size_t>> triangles(n);
  Point_matrix points = surface.points;
  normalize(points);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    areas[surface.component_of_triangle[t]] += twice_area(points, surface.triangles[t]);
    triangles[surface.component_of_triangle[t]].push_back(t);
  }
  const auto vertices_of = [&](const std::size_t c, const auto& f) {
    for(const std::size_t t : triangles[c])
      for(const std::size_t v : surface.triangles[t])
        f(surface.origins[v]);
  };
  const std::vector<std::size_t> owners
    = owners_of_fragments(areas, surface.representatives.size(), vertices_of);
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < n; ++c)
    if(areas[c] > 0 && owners[c] == c)
      result.push_back(c);
  if(result.size() > 1 && components == Options::Components::REFUSE)
    throw std::invalid_argument(
      diagnosis.components > 1
        ? "the surface has " + std::to_string(result.size()) + " connected components"
        : "the surface falls into " + std::to_string(result.size())
            + " components where it is not manifold: " + diagnosis.first_defect);
  if(components == Options::Components::LARGEST)
    result.resize(1);
  return result;
}

} // namespace internal

CGAL_CANONICAL_POSE_3_INLINE Prepared_surface_3
prepare_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons,
                const Options& options)
{
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return prepare_surface(points, polygons, options); });
  internal::check_options(options, static_cast<std::size_t>(points.rows()));
  internal::check_factors(options.stiffness, points.rows(), "stiffness", "vertex", false);
  const internal::Examined_surface examined
    = internal::examine_surface(points, internal::with_smallest_corners_first(polygons));
  const Diagnosis_3& diagnosis = examined.diagnosis;
  const Repaired_surface_3& surface = examined.surface;
  const std::vector<std::size_t> posed
    = internal::components_to_pose(surface, diagnosis, options.components);
  if(!options.make_body
     && (options.body == Options::Body::TETGEN || options.body == Options::Body::MESH_3))
  {
    if(!diagnosis.is_clean())
      throw std::invalid_argument(diagnosis.first_defect);
    if(options.contacts == Options::Contacts::CUT)
      throw std::invalid_argument("contacts can only be cut if the body is the lattice");
  }
  std::vector<Surface_component_3> components = internal::components_of_indices(surface, posed);
  if(options.contacts == Options::Contacts::CUT)
    std::transform(components.begin(), components.end(), components.begin(), cut_contacts);
  using internal::Indexed_vector;
  using internal::Row_index;
  using internal::Vertex_index;
  internal::Vertex_map rows;
  rows.representatives
    = Indexed_vector<Vertex_index, Vertex_index>::of_numbers(surface.representatives);
  rows.representative_rows
    = Indexed_vector<Row_index, Row_index>::of_numbers(surface.representatives);
  rows.vertex_of_row
    = internal::identity_map<Row_index, Vertex_index>(surface.representatives.size());
  Prepared_surface_3 result
    = internal::prepared(diagnosis, points, std::move(components), std::move(rows),
                         internal::vertices_of_others(surface, posed), options);
  if(options.stiffness.size() > 0)
    for(Prepared_surface_3::Component& component : result.components)
      component.options.stiffness
        = internal::values_at(options.stiffness, component.surface.origins);
  return result;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_PREPARE_SURFACE_IMPL_H
