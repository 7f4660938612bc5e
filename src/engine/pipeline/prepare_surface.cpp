// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "component_options.h"
#include "component_roles.h"
#include "fragments.h"
#include "refine_components.h"
#include "shares_of_cells.h"
#include "../surface/examine_surface.h"
#include "../surface/refined_surface.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/cut_contacts.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>
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

namespace internal {

// Examines polygons with the smallest corner first, like those of `index_polygons()`: so a soup and a
// mesh have the same pose, bit for bit.
inline Examined_surface examine_polygons(const Point_matrix& points, const Face_list& polygons,
                                         const bool searches_self_intersections)
{
  Face_list rotated;
  rotated.reserve(polygons.size());
  std::vector<std::size_t> corners;
  for(const Face_list::Face polygon : polygons)
  {
    corners.assign(polygon.begin(), polygon.end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    rotated.push_back(corners);
  }
  return examine_surface(points, rotated, searches_self_intersections);
}

// The components of a surface, in one pass over it. A single one has its arrays.
inline std::vector<Surface_component_3> components_of(Repaired_surface_3 surface)
{
  std::vector<Surface_component_3> result(surface.number_of_components);
  if(result.size() == 1)
  {
    result[0].points = std::move(surface.points);
    result[0].triangles = std::move(surface.triangles);
    result[0].caps = std::move(surface.caps);
    result[0].face_of_triangle = std::move(surface.face_of_triangle);
    result[0].origins = std::move(surface.origins);
    result[0].body_origins = result[0].origins;
    return result;
  }
  std::vector<std::size_t> component_of_vertex(surface.origins.size());
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::size_t c = surface.component_of_triangle[t];
    result[c].triangles.push_back(surface.triangles[t]);
    result[c].face_of_triangle.push_back(surface.face_of_triangle[t]);
    for(const std::size_t v : surface.triangles[t])
      component_of_vertex[v] = c;
  }
  for(const auto& cap : surface.caps)
    result[component_of_vertex[cap[0]]].caps.push_back(cap);

  std::vector<std::size_t> number(surface.origins.size());
  std::vector<std::vector<std::size_t>> vertices(result.size());
  for(std::size_t v = 0; v < number.size(); ++v)
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

// Whether each component is a fragment of another one after splitting.
inline std::vector<bool> find_fragments(const std::vector<Surface_component_3>& components,
                                        const std::size_t number_of_vertices)
{
  const std::vector<std::size_t> owners = owners_of_fragments(
    relative_areas(components), number_of_vertices, [&](const std::size_t c, const auto& f) {
      for(const std::size_t v : components[c].origins)
        f(v);
    });
  std::vector<bool> result;
  for(std::size_t c = 0; c < components.size(); ++c)
    result.push_back(owners[c] != c);
  return result;
}

// Throws `std::invalid_argument` if there is nothing to pose, or too much.
inline void check_roles(const std::vector<Component_role>& roles, const Diagnosis_3& diagnosis,
                        const std::vector<Surface_component_3>& surfaces,
                        const Options::Components components)
{
  const std::size_t n = posed_components(roles).size();
  if(n == 0)
    throw std::invalid_argument("the surface has no area: all its faces are degenerate");
  if(n > 1 && refuses_several(components))
    throw refusal_of_several(diagnosis.components > 1
                               ? "the surface has " + std::to_string(n) + " connected components"
                               : "the surface falls into " + std::to_string(n)
                                   + " components where it is not manifold ("
                                   + diagnosis.first_defect + ')',
                             roles, [&](const std::size_t c) { return surfaces[c].origins; });
}

} // namespace internal

Prepared_surface_3 prepare_surface(const Point_matrix& points, const Face_list& polygons,
                                   const Options& options)
{
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return prepare_surface(points, polygons, options); });
  internal::check_options(options, static_cast<std::size_t>(points.rows()));
  internal::check_factors(options.stiffness, points.rows(), "stiffness", "vertex", false);
  const bool has_mesher = !options.make_body
                          && (options.body == Options::Body::TETGEN
                              || options.body == Options::Body::MESH_3);
  internal::Examined_surface examined = internal::examine_polygons(
    points, polygons, has_mesher || options.searches_self_intersections);
  const Diagnosis_3& diagnosis = examined.diagnosis;
  const std::vector<std::size_t> representatives = std::move(examined.surface.representatives);
  std::vector<Surface_component_3> components
    = internal::components_of(std::move(examined.surface));
  const bool has_lattice = !options.make_body && !has_mesher;
  const std::vector<internal::Component_role> roles = internal::Component_roles::find(
    components, internal::find_fragments(components, representatives.size()),
    options.components, has_lattice);
  internal::check_roles(roles, diagnosis, components, options.components);
  if(has_mesher)
  {
    if(!diagnosis.is_clean())
      throw std::invalid_argument(diagnosis.first_defect);
    if(options.contacts == Options::Contacts::CUT)
      throw std::invalid_argument("contacts can only be cut if the body is the lattice");
  }
  if(options.contacts == Options::Contacts::CUT)
    for(const std::size_t c : internal::posed_components(roles))
      components[c] = cut_contacts(components[c]);
  using internal::Indexed_vector;
  using internal::Row_index;
  using internal::Vertex_index;
  internal::Vertex_map rows;
  rows.representatives = Indexed_vector<Vertex_index, Vertex_index>::of_numbers(representatives);
  rows.representative_rows = Indexed_vector<Row_index, Row_index>::of_numbers(representatives);
  rows.vertex_of_row = internal::identity_map<Row_index, Vertex_index>(representatives.size());
  Prepared_surface_3 result
    = internal::prepared(diagnosis, points, std::move(components), std::move(rows), roles, options);
  internal::refine(result.components);
  for(auto& [refined, local] : result.components)
  {
    if(options.matching_weights.size() > 0)
      local.matching_weights = internal::with_added(refined, local.matching_weights);
    if(options.stiffness.size() > 0)
      local.stiffness
        = internal::with_added(refined, internal::values_at(options.stiffness, refined.origins));
  }
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
