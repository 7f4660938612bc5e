// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_SURFACE_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_SURFACE_IMPL_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Component_poses.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Factor_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Solver.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/component_body.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_component.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/poses.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The components of a surface with the given indices, in one pass over it.
inline std::vector<Posed_component> components_of_indices(const Repaired_surface_3& surface,
                                                          const std::vector<std::size_t>& indices)
{
  const std::size_t none = indices.size();
  std::vector<std::size_t> position(surface.number_of_components, none);
  for(std::size_t c = 0; c < indices.size(); ++c)
    position[indices[c]] = c;

  std::vector<Posed_component> result(indices.size());
  std::vector<std::size_t> component_of_vertex(surface.origins.size(), none);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::size_t c = position[surface.component_of_triangle[t]];
    if(c == none)
      continue;
    result[c].triangles.push_back(surface.triangles[t]);
    result[c].faces.push_back(surface.face_of_triangle[t]);
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
    result[c].points.resize(static_cast<Eigen::Index>(vertices[c].size()), 3);
    for(std::size_t i = 0; i < vertices[c].size(); ++i)
    {
      result[c].points.row(static_cast<Eigen::Index>(i))
        = surface.points.row(static_cast<Eigen::Index>(vertices[c][i]));
      result[c].vertices.push_back(surface.origins[vertices[c][i]]);
    }
    result[c].field_rows = result[c].vertices;
    for(auto* const triangles : {&result[c].triangles, &result[c].caps})
      for(Index_triangle& t : *triangles)
        for(std::size_t& v : t)
          v = number[v];
  }
  return result;
}

// canonical_pose_3() for any polygons: examines and repairs them, brings the components requested into
// their pose, and carries the pose back to the vertices of the input.
class Pose_of_surface
{
public:
  Pose_of_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons,
                  const Options& options, const Body_makers& bodies, const Factor_makers& solver)
    : m_points(points), m_polygons(polygons), m_options(options), m_solver(options, solver),
      m_bodies(bodies)
  {}

  Result run() const
  {
    check_options(m_options, static_cast<std::size_t>(m_points.rows()));
    check_factors(m_options.stiffness, m_points.rows(), "stiffness", "vertex", false);
    Real_timer timer;
    timer.start();
    const Diagnosis_3 diagnosis = diagnose(m_points, m_polygons);
    const Repaired_surface_3 surface = repair_surface(m_points, m_polygons);
    const std::vector<std::size_t> posed = components_to_pose(surface, diagnosis);
    if(!m_options.make_body
       && (m_options.body == Options::Body::TETGEN || m_options.body == Options::Body::MESH_3))
      if(!diagnosis.is_clean())
        throw std::invalid_argument(diagnosis.first_defect);
    const std::vector<Posed_component> components = components_of_indices(surface, posed);
    Component_poses poses(m_points, rows(surface), components, vertices_of_others(surface, posed),
                          m_options);
    timer.stop();

    Result result = poses.run([&](const std::size_t c, Component_values values) {
      if(m_options.stiffness.size() > 0)
        values.stiffness = Component_poses::values_at(m_options.stiffness, components[c].vertices);
      const auto make_body = [&](const Landmark_fields_3& fields, const Eigen::VectorXd& shares) {
        return body_of_surface(components[c], fields, values.stiffness, m_options, m_bodies,
                               shares);
      };
      return pose_of_component(components[c], values, m_options, m_solver, make_body, diagnosis);
    });
    result.summary.add_seconds("diagnosis", timer.time());
    return result;
  }

private:
  // Components that are connected at vertices where the surface was split count as one if all but the
  // largest are fragments; these get no pose of their own.
  static constexpr double SHARE_OF_FRAGMENTS = 0.05;

  static Input_rows rows(const Repaired_surface_3& surface)
  {
    std::vector<std::size_t> vertices(surface.representatives.size());
    std::iota(vertices.begin(), vertices.end(), std::size_t(0));
    return {surface.representatives, std::move(vertices), "vertex"};
  }

  // The vertices of the components that are not among those to pose.
  static std::vector<std::vector<std::size_t>>
  vertices_of_others(const Repaired_surface_3& surface, const std::vector<std::size_t>& posed)
  {
    std::vector<std::vector<std::size_t>> result(surface.number_of_components);
    std::vector<bool> is_posed(surface.number_of_components, false);
    for(const std::size_t c : posed)
      is_posed[c] = true;
    for(std::size_t t = 0; t < surface.triangles.size(); ++t)
      if(!is_posed[surface.component_of_triangle[t]])
        for(const std::size_t v : surface.triangles[t])
          result[surface.component_of_triangle[t]].push_back(surface.origins[v]);
    return result;
  }

  std::vector<std::size_t> components_to_pose(const Repaired_surface_3& surface,
                                              const Diagnosis_3& diagnosis) const
  {
    const std::size_t n = surface.number_of_components;
    std::vector<double> areas(n, 0.);
    Disjoint_sets groups(n);
    std::vector<std::size_t> component_of_row(static_cast<std::size_t>(m_points.rows()), n);
    Point_matrix points = surface.points;
    normalize(points);
    for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const std::size_t component = surface.component_of_triangle[t];
      areas[component] += twice_area(points, surface.triangles[t]);
      for(const std::size_t v : surface.triangles[t])
      {
        std::size_t& other = component_of_row[surface.origins[v]];
        if(other == n)
          other = component;
        groups.unite(component, other);
      }
    }
    // components come by decreasing area, so the first of a group is its largest
    std::vector<std::size_t> first(n, n);
    std::vector<double> area_of_rest(n, 0.);
    for(std::size_t c = 0; c < n; ++c)
    {
      std::size_t& f = first[groups.representative(c)];
      if(f == n)
        f = c;
      else
        area_of_rest[f] += areas[c];
    }
    std::vector<std::size_t> result;
    for(std::size_t c = 0; c < n; ++c)
    {
      const std::size_t f = first[groups.representative(c)];
      if(areas[c] > 0 && (c == f || area_of_rest[f] > SHARE_OF_FRAGMENTS * areas[f]))
        result.push_back(c);
    }
    if(result.size() > 1 && m_options.components == Options::Components::REFUSE)
      throw std::invalid_argument(
        diagnosis.components > 1
          ? "the surface has " + std::to_string(result.size()) + " connected components"
          : "the surface falls into " + std::to_string(result.size())
              + " components where it is not manifold: " + diagnosis.first_defect);
    if(m_options.components == Options::Components::LARGEST)
      result.resize(1);
    return result;
  }

  const Point_matrix& m_points;
  const std::vector<std::vector<std::size_t>>& m_polygons;
  const Options& m_options;
  const Solver m_solver;
  const Body_makers m_bodies;
};

CGAL_CANONICAL_POSE_3_INLINE Result
pose_of_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons,
                const Options& options, const Body_makers& bodies, const Factor_makers& solver)
{
  const Thread_limit limit(options);
  return Pose_of_surface(points, polygons, options, bodies, solver).run();
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_SURFACE_IMPL_H
