// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_COMPONENT_OPTIONS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_COMPONENT_OPTIONS_H

#include "Options_constraints.h"
#include "check_method_options.h"
#include "component_roles.h"
#include "make_vertex_map.h"
#include "shares_of_cells.h"
#include "../stance/limb_goals.h"

#include <CGAL/Canonical_pose_3/Constraints_3.h>
#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/registration/Constraint_element_traits.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/internal/target/check_landmark_fields.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Throws `std::invalid_argument` for options that do not apply to unfolding.
inline void check_unfolding(const Options& options)
{
  if(options.given.target)
    throw std::invalid_argument("option given.target is set, but the target is that of unfolding");
  if(options.takes_mirror_image)
    throw std::invalid_argument(
      "option takes_mirror_image is set, but unfolding does not mirror a surface");
}

// Throws `std::invalid_argument` for options that do not fit an input of n vertices.
inline void check_options(const Options& options, const std::size_t n)
{
  check_method_options(options);
  check_factors(options.matching_weights, static_cast<Eigen::Index>(n), "matching weight", "vertex",
                true);
  if(options.target_mode == Options::Target_mode::UNFOLDING)
    check_unfolding(options);
  Options_constraints(options.constraints, n);
  check_limb_directions(options.limb_directions, n);
  for(Eigen::Index i = 0; i < options.followers.rows(); ++i)
    if(!options.followers.row(i).allFinite())
      throw std::invalid_argument("follower " + std::to_string(i)
                                  + " has a coordinate that is not finite");
}

// For each vertex of the input, its copies in the component to which it belongs.
inline Indexed_vector<Vertex_index, std::vector<std::size_t>>
copies_in_components(const std::vector<Prepared_surface_3::Component>& components,
                     const Vertex_map& map)
{
  Indexed_vector<Vertex_index, std::vector<std::size_t>> result(map.number_of_vertices());
  for(std::size_t c = 0; c < components.size(); ++c)
    for(std::size_t i = 0; i < components[c].surface.body_origins.size(); ++i)
      if(const Vertex_index v = vertex_of(components[c].surface, i);
         map.component_of[v] == Component_index(c))
        result[v].push_back(i);
  return result;
}

// Assigns each element of a constraint to the component of its vertices. It acts on all copies that a
// vertex has there, which share its stiffness.
template <class Element>
void distribute(const std::vector<Element>& elements, const Vertex_map& map,
                std::vector<Element> Constraints_3::*list,
                std::vector<Prepared_surface_3::Component>& components)
{
  if(elements.empty())
    return;
  const Indexed_vector<Vertex_index, std::vector<std::size_t>> copies
    = copies_in_components(components, map);
  using Traits = Constraint_element_traits<Element>;
  for(std::size_t i = 0; i < elements.size(); ++i)
  {
    const std::string name = Traits::name + (' ' + std::to_string(i));
    const auto vertices = vertices_of(elements[i]);
    const Component_index component = map.component_of[Vertex_index(vertices.front())];
    Element local = elements[i];
    for(std::size_t* const vertex : Traits::pointers_to_vertices(local))
    {
      const auto v = Vertex_index(*vertex);
      if(map.component_of[v] == Component_index::NONE)
        throw std::invalid_argument(name + " names vertex " + std::to_string(*vertex)
                                    + ", which has no pose of its own: it is not on the surface, "
                                      "or on another component");
      if(map.component_of[v] != component)
        throw std::invalid_argument(name + " names vertices " + std::to_string(vertices.front())
                                    + " and " + std::to_string(*vertex)
                                    + ", which belong to different components");
      *vertex = map.local_of[v];
    }
    if(!Traits::defect(local).empty())
      throw std::invalid_argument(name + " names vertices " + std::to_string(vertices.front())
                                  + " and " + std::to_string(vertices.back())
                                  + ", which are at the same position and became one");
    std::vector<Element> shared = {local};
    for(std::size_t k = 0; k < vertices.size(); ++k)
    {
      const auto& of_vertex = copies[map.representatives[Vertex_index(vertices[k])]];
      std::vector<Element> all;
      for(Element element : shared)
        for(const std::size_t copy : of_vertex)
        {
          *Traits::pointers_to_vertices(element)[k] = copy;
          all.push_back(element);
          all.back().stiffness /= static_cast<double>(of_vertex.size());
        }
      shared = std::move(all);
    }
    auto& of_component = components[static_cast<std::size_t>(component)].options.constraints.*list;
    of_component.insert(of_component.end(), shared.begin(), shared.end());
  }
}

// The indices of the limb directions of a component: those of all, and those with its vertices.
inline std::vector<std::size_t> limb_directions_of(const Component_index component,
                                                   const std::vector<Limb_direction_3>& directions,
                                                   const Vertex_map& map)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < directions.size(); ++i)
  {
    const auto* const vertex = std::get_if<std::size_t>(&directions[i].limb);
    if(vertex == nullptr || map.component_of[Vertex_index(*vertex)] == component)
      result.push_back(i);
  }
  return result;
}

// Throws `Limb_direction_error` for a vertex that belongs to no component.
inline void distribute_limb_directions(const std::vector<Limb_direction_3>& directions,
                                       const Vertex_map& map,
                                       std::vector<Prepared_surface_3::Component>& components)
{
  for(const std::size_t i : limb_directions_of(Component_index::NONE, directions, map))
    if(const auto* const vertex = std::get_if<std::size_t>(&directions[i].limb))
      throw Limb_direction_error(i, "names vertex " + std::to_string(*vertex)
                                      + ", which has no pose of its own: it is not on the surface, "
                                        "or on another component");
  for(std::size_t c = 0; c < components.size(); ++c)
    for(const std::size_t i : limb_directions_of(Component_index(c), directions, map))
    {
      Limb_direction_3 local = directions[i];
      if(auto* const vertex = std::get_if<std::size_t>(&local.limb))
        *vertex = map.local_of[Vertex_index(*vertex)];
      components[c].options.limb_directions.push_back(local);
    }
}

// Throws `std::invalid_argument` if given results do not match the input.
inline void check_given(const Intermediate_results& given, const Vertex_map& map,
                        const std::size_t number_of_components)
{
  if(given.landmark_fields)
  {
    if(number_of_components > 1)
      throw std::invalid_argument("distances can be given for a single component only");
    check_shape(*given.landmark_fields, map.number_of_rows(), "the given distances");
  }
  if(given.target && given.target->rows() != static_cast<Eigen::Index>(map.number_of_rows()))
    throw std::invalid_argument("the given target has " + std::to_string(given.target->rows())
                                + " rows, but there are " + std::to_string(map.number_of_rows())
                                + " vertices");
}

// Given distances for the rows of the surface.
inline Landmark_fields_3 component_fields(const Landmark_fields_3& fields, const Vertex_map& map,
                                          const Surface_component_3& surface)
{
  const std::size_t none = surface.origins.size();
  Indexed_vector<Row_index, std::size_t> surface_vertex(map.number_of_rows(), none);
  for(std::size_t i = surface.origins.size(); i-- > 0;)
    surface_vertex[row_of(surface, i)] = i;

  Landmark_fields_3 result;
  result.covering_radius = fields.covering_radius;
  for(const std::size_t landmark : fields.landmarks)
  {
    const auto row = Row_index(landmark);
    result.landmarks.push_back(surface_vertex[map.representative_rows[row]]);
    if(result.landmarks.back() == none)
      throw std::invalid_argument("the given landmark " + map.name_of_row(row)
                                  + " is not on the surface");
  }
  result.distances.resize(surface.points.rows(), fields.distances.cols());
  for(Eigen::Index j = 0; j < result.distances.cols(); ++j)
    for(Eigen::Index i = 0; i < result.distances.rows(); ++i)
    {
      const auto row = static_cast<Eigen::Index>(surface.origins[static_cast<std::size_t>(i)]);
      check_distance(fields, row, j, "the given distances", map.row_name);
      result.distances(i, j) = fields.distances(row, j);
      if(result.distances(i, j) > LARGEST_LENGTH)
        throw std::invalid_argument("the given distances: that of "
                                    + map.name_of_row(Row_index(static_cast<std::size_t>(row)))
                                    + " is too large");
    }
  check_covering_radius(fields, "the given distances");
  return result;
}

// Given results for the rows of the surface.
inline Intermediate_results component_results(const Intermediate_results& given,
                                              const Vertex_map& map,
                                              const Surface_component_3& surface)
{
  Intermediate_results result;
  if(given.landmark_fields)
    result.landmark_fields = component_fields(*given.landmark_fields, map, surface);
  if(given.target)
  {
    result.target = rows_at(*given.target, surface.origins);
    for(std::size_t i = 0; i < surface.origins.size(); ++i)
      if(!result.target->row(static_cast<Eigen::Index>(i)).allFinite())
        throw std::invalid_argument("the given target of " + map.name_of_row(row_of(surface, i))
                                    + " is not finite");
  }
  return result;
}

// The attached vertices, then the followers of the options.
inline Point_matrix points_of_followers(const Point_matrix& points, const Vertex_map& map,
                                        const Point_matrix& followers)
{
  const auto n = static_cast<Eigen::Index>(map.attached.size());
  Point_matrix result(n + followers.rows(), 3);
  result.topRows(n) = rows_at(rows_by<Vertex_index>(points), map.attached);
  result.bottomRows(followers.rows()) = followers;
  return result;
}

// Assigns options to the components with a pose, except for the stiffness. The others, vertices without
// a component, and followers are assigned to one of them. `rows`: the first four members of the map.
inline Prepared_surface_3 prepared(Diagnosis_3 diagnosis, const Point_matrix& points,
                                   std::vector<Surface_component_3> components, Vertex_map rows,
                                   const std::vector<Component_role>& roles, const Options& options)
{
  Prepared_surface_3 result;
  result.diagnosis = std::move(diagnosis);
  result.points = points;
  const std::vector<std::size_t> posed = posed_components(roles);
  check_given(options.given, rows, posed.size());
  check_unit(points);
  std::vector<Surface_component_3> surfaces;
  std::vector<Other_component> others;
  for(std::size_t c = 0; c < components.size(); ++c)
    if(roles[c].kind == Component_role::POSED)
      surfaces.push_back(std::move(components[c]));
    else
      others.push_back({c, std::move(components[c].body_origins), roles[c]});
  const std::vector<double> shares = shares_of_cells(surfaces, relative_areas(surfaces));
  result.vertex_map = std::move(rows);
  Vertex_map& map = result.vertex_map;
  locate_vertices(surfaces, map);
  const Point_matrix followers = points_of_followers(points, map, options.followers);
  std::vector<Nearest_component> nearest(static_cast<std::size_t>(followers.rows()));
  if((surfaces.size() > 1 || !others.empty()) && !nearest.empty())
    nearest = nearest_components(followers, surfaces);
  result.followers = follow_components(others, posed, points, map, nearest);
  map.followers_of = Indexed_vector<Component_index, std::vector<std::size_t>>(surfaces.size());
  for(std::size_t i = 0; i < nearest.size(); ++i)
    map.followers_of[nearest[i].component].push_back(i);

  for(Surface_component_3& surface : surfaces)
  {
    const std::size_t c = result.components.size();
    result.components.emplace_back();
    Component_options& local = result.components.back().options;
    static_cast<Method_options&>(local) = options;
    local.return_landmark_fields = options.return_landmark_fields && surfaces.size() == 1;
    local.constraints.function = options.constraints.function;
    if(options.matching_weights.size() > 0)
      local.matching_weights = values_at(options.matching_weights, surface.body_origins);
    local.followers = rows_at(followers, map.followers_of[Component_index(c)]);
    local.given = component_results(options.given, map, surface);
    surface.share_of_cells = shares[c];
    result.components.back().surface = std::move(surface);
  }
  const Constraints_3& constraints = options.constraints;
  distribute(constraints.springs, map, &Constraints_3::springs, result.components);
  distribute(constraints.directions, map, &Constraints_3::directions, result.components);
  distribute(constraints.handles, map, &Constraints_3::handles, result.components);
  distribute(constraints.symmetric_pairs, map, &Constraints_3::symmetric_pairs, result.components);
  distribute_limb_directions(options.limb_directions, map, result.components);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_COMPONENT_OPTIONS_H
