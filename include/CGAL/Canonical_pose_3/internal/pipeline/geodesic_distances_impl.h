// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_GEODESIC_DISTANCES_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_GEODESIC_DISTANCES_IMPL_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/check_method_options.h>
#include <CGAL/Canonical_pose_3/internal/support/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/solver_of_options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/with_geodesics.h>
#include <CGAL/Canonical_pose_3/internal/soup/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/soup/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

inline Eigen::MatrixXd distances_on_surface(const Repaired_surface_3& surface,
                                            const std::vector<std::size_t>& sources,
                                            const Options& options)
{
  const Indexed_mesh mesh = indexed_mesh(surface.points, surface.triangles);
  std::vector<Indexed_mesh::Vertex_index> vertices;
  for(const std::size_t source : sources)
    vertices.emplace_back(static_cast<Indexed_mesh::size_type>(source));
  return with_geodesics(mesh, options, solver_of_options(options).lane_factor_maker(), 1,
                        [&](const auto& geodesics) { return geodesics.distances(vertices); });
}

} // namespace internal

CGAL_CANONICAL_POSE_3_INLINE Eigen::MatrixXd
geodesic_distances(const Point_matrix& points,
                   const std::vector<std::vector<std::size_t>>& polygons,
                   const std::vector<std::size_t>& sources, const Options& options,
                   const Distances_function& function)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute(
      [&] { return geodesic_distances(points, polygons, sources, options, function); });
  const Repaired_surface_3 surface = repair_surface(points, polygons);
  const std::vector<std::size_t> copies = internal::first_copies(surface);
  const auto none = std::find(copies.begin(), copies.end(), surface.origins.size());
  if(none != copies.end())
    throw std::invalid_argument("vertex " + std::to_string(none - copies.begin())
                                + " belongs to no face: there are no distances from or to it");
  std::vector<std::size_t> sources_on_surface;
  for(const std::size_t source : sources)
  {
    if(source >= copies.size())
      throw std::invalid_argument("a source names vertex " + std::to_string(source)
                                  + ", but there are " + std::to_string(copies.size()));
    sources_on_surface.push_back(copies[source]);
  }
  const Eigen::MatrixXd distances
    = function ? internal::with_faces_of_input(
        surface.face_of_triangle,
        [&] { return function(surface.points, surface.triangles, sources_on_surface); })
               : internal::distances_on_surface(surface, sources_on_surface, options);
  if(distances.rows() != surface.points.rows()
     || distances.cols() != static_cast<Eigen::Index>(sources.size()))
    throw std::invalid_argument("the function of the distances returned "
                                + std::to_string(distances.rows()) + " x "
                                + std::to_string(distances.cols()) + " of them");
  Eigen::MatrixXd result(static_cast<Eigen::Index>(copies.size()), distances.cols());
  for(std::size_t v = 0; v < copies.size(); ++v)
    result.row(static_cast<Eigen::Index>(v)) = distances.row(static_cast<Eigen::Index>(copies[v]));
  return result;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_GEODESIC_DISTANCES_IMPL_H
