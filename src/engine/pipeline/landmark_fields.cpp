// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_method_options.h"
#include "fields_of_function.h"
#include "solver_of_options.h"
#include "with_geodesics.h"
#include "../surface/root_of_area.h"
#include "../support/Thread_limit.h"
#include "../target/check_number_of_landmarks.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/internal/target/check_landmark_fields.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// Distances for targets are smoothed over a width that does not depend on the mesh: kinks, where
// shortest paths from two sides meet, move when a shape bends. Returns the time step factor of the
// heat method for it.
inline double smoothing_time_step_factor(const Surface_component_3& surface)
{
  constexpr double width = 0.065; // by the square root of the area
  double lengths = 0;
  for(const Index_triangle& t : surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      lengths += (surface.points.row(static_cast<Eigen::Index>(t[k]))
                  - surface.points.row(static_cast<Eigen::Index>(t[(k + 1) % 3])))
                   .norm();
  const double mean = lengths / static_cast<double>(3 * surface.triangles.size());
  const double ratio
    = mean > 0 ? width * root_of_area(surface.points, surface.triangles) / mean : 1;
  return (std::min)((std::max)(ratio * ratio, 1.), 1e6);
}

inline Indexed_mesh::Vertex_index vertex_of_row(const std::size_t row)
{
  return Indexed_mesh::Vertex_index(static_cast<Indexed_mesh::size_type>(row));
}

// The rows of the vertices of a coarse surface.
inline Landmark_fields_3 fields_at(const Landmark_fields_3& fields, const Coarse_surface_3& coarse)
{
  Landmark_fields_3 result;
  result.covering_radius = fields.covering_radius;
  for(const std::size_t landmark : fields.landmarks)
  {
    const auto position
      = std::lower_bound(coarse.vertices.begin(), coarse.vertices.end(), landmark);
    if(position == coarse.vertices.end() || *position != landmark)
      throw std::invalid_argument("the given landmark " + std::to_string(landmark)
                                  + " is not a vertex of the coarse surface");
    result.landmarks.push_back(static_cast<std::size_t>(position - coarse.vertices.begin()));
  }
  result.distances.resize(static_cast<Eigen::Index>(coarse.vertices.size()),
                          fields.distances.cols());
  for(Eigen::Index j = 0; j < fields.distances.cols(); ++j)
    result.distances.col(j) = values_at(fields.distances.col(j), coarse.vertices);
  return result;
}

} // namespace internal

Coarse_surface_3 coarse_surface(const Surface_component_3& surface,
                                const Component_options& options)
{
  const auto n = static_cast<std::size_t>(surface.points.rows());
  const std::size_t number = options.number_of_coarse_vertices == 0
                               ? n
                               : (std::max)(options.number_of_coarse_vertices,
                                            4 * (std::min)(options.number_of_landmarks, n));
  return coarse_surface(surface, number,
                        options.given.landmark_fields ? options.given.landmark_fields->landmarks
                                                      : std::vector<std::size_t>());
}

Landmark_fields_3 landmark_fields(const Coarse_surface_3& coarse, const Component_options& options)
{
  if(options.given.landmark_fields)
  {
    internal::check_shape(*options.given.landmark_fields, coarse.number_of_surface_vertices(),
                          "the given distances");
    return internal::fields_at(*options.given.landmark_fields, coarse);
  }
  return landmark_fields(coarse.surface, options);
}

Landmark_fields_3 landmark_fields(const Surface_component_3& surface, const Method_options& options)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return landmark_fields(surface, options); });
  internal::check_number_of_landmarks(options.number_of_landmarks,
                                      static_cast<std::size_t>(surface.points.rows()));
  if(options.landmark_fields_function)
    return internal::fields_of_function(options.landmark_fields_function, surface, options);
  const internal::Indexed_mesh mesh = internal::indexed_mesh(surface.points, surface.triangles);
  const auto first = internal::vertex_of_row(internal::first_landmark(surface, options));
  return internal::with_geodesics(
    mesh, options, internal::solver_of_options(options).factor_maker(),
    internal::smoothing_time_step_factor(surface), [&](const auto& geodesics) {
      return front_landmarks(geodesics, options.number_of_landmarks, first);
    });
}

Landmark_fields_3 landmark_fields(const Surface_component_3& surface,
                                  const std::vector<std::size_t>& landmarks,
                                  const Method_options& options)
{
  internal::check_method_options(options);
  internal::check_landmarks(landmarks, static_cast<std::size_t>(surface.points.rows()),
                            "the landmarks");
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return landmark_fields(surface, landmarks, options); });
  if(options.landmark_fields_function)
    return internal::fields_of_function(options.landmark_fields_function, surface, options,
                                        landmarks);
  const internal::Indexed_mesh mesh = internal::indexed_mesh(surface.points, surface.triangles);
  std::vector<internal::Indexed_mesh::Vertex_index> sources;
  for(const std::size_t landmark : landmarks)
    sources.push_back(internal::vertex_of_row(landmark));
  Landmark_fields_3 result = landmark_fields(internal::with_geodesics(
    mesh, options, internal::solver_of_options(options).factor_maker(),
    internal::smoothing_time_step_factor(surface),
    [&](const auto& geodesics) { return geodesics.distances(sources); }));
  result.landmarks = landmarks; // there may be other points in the same place
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
