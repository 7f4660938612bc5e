// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Split_surface.h"
#include "check_method_options.h"
#include "solver_of_options.h"
#include "with_geodesics.h"
#include "../surface/refined_surface.h"
#include "../surface/without_degenerate_faces.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/has_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether the heat method would not be accurate at each vertex: whether its component is coarse.
inline std::vector<bool> coarse_vertices(const Split_surface& surface)
{
  const auto& components = surface.component_of_triangle;
  std::vector<Edge_length_measure> measures(
    components.empty() ? 0 : 1 + *std::max_element(components.begin(), components.end()));
  Point_matrix points = surface.points;
  normalize(points);
  for(std::size_t t = 0; t < components.size(); ++t)
    measures[components[t]].add(points, surface.triangles[t]);
  std::vector<bool> result(static_cast<std::size_t>(points.rows()), false);
  for(std::size_t t = 0; t < components.size(); ++t)
    if(measures[components[t]].is_coarse())
      for(const std::size_t v : surface.triangles[t])
        result[v] = true;
  return result;
}

inline Eigen::MatrixXd distances_on_surface(const Split_surface& surface,
                                            const std::vector<std::size_t>& sources,
                                            const Options& options)
{
  const Indexed_mesh mesh = indexed_mesh(surface.points, surface.triangles);
  const std::vector<bool> is_coarse = coarse_vertices(surface);
  Eigen::MatrixXd result(surface.points.rows(), static_cast<Eigen::Index>(sources.size()));
  const auto measure = [&](const bool of_coarse, const Options& used) {
    std::vector<Indexed_mesh::Vertex_index> vertices;
    std::vector<Eigen::Index> columns;
    for(std::size_t j = 0; j < sources.size(); ++j)
      if(is_coarse[sources[j]] == of_coarse)
      {
        vertices.emplace_back(static_cast<Indexed_mesh::size_type>(sources[j]));
        columns.push_back(static_cast<Eigen::Index>(j));
      }
    if(vertices.empty())
      return;
    const Eigen::MatrixXd distances
      = with_geodesics(mesh, used, solver_of_options(used).factor_maker(), 1,
                       [&](const auto& geodesics) { return geodesics.distances(vertices); });
    for(std::size_t j = 0; j < columns.size(); ++j)
      result.col(columns[j]) = distances.col(static_cast<Eigen::Index>(j));
  };
  Options wavefront = options;
  wavefront.geodesics = Options::Geodesics::WAVEFRONT;
  measure(false, options);
  measure(true, wavefront);
  return result;
}

// By a function that may require faces with an area.
inline Eigen::MatrixXd distances_by_function(const Split_surface& surface,
                                             const std::vector<std::size_t>& sources,
                                             const Distances_function& function)
{
  Point_matrix normalized = surface.points;
  normalize(normalized);
  if(!has_area(normalized, surface.triangles))
    throw no_face_has_area();
  const Eigen::MatrixXd distances = with_faces_of_input(surface.face_of_triangle, [&] {
    return function(without_degenerate_faces(surface.points, surface.triangles), surface.triangles,
                    sources);
  });
  if(distances.rows() != surface.points.rows()
     || distances.cols() != static_cast<Eigen::Index>(sources.size()))
    throw std::invalid_argument("the function of the distances returned "
                                + std::to_string(distances.rows()) + " x "
                                + std::to_string(distances.cols()) + " of them");
  return distances;
}

// The vertex of the surface for each source.
inline std::vector<std::size_t> sources_on_surface(const std::vector<std::size_t>& sources,
                                                   const std::vector<std::size_t>& copies,
                                                   const std::size_t none)
{
  std::vector<std::size_t> result;
  for(const std::size_t source : sources)
  {
    if(source >= copies.size())
      throw std::invalid_argument("a source names vertex " + std::to_string(source)
                                  + ", but there are " + std::to_string(copies.size()));
    if(copies[source] == none)
      throw std::invalid_argument("a source names vertex " + std::to_string(source)
                                  + ", which belongs to no face: there are no distances from it");
    result.push_back(copies[source]);
  }
  return result;
}

} // namespace internal

Eigen::MatrixXd geodesic_distances(const Point_matrix& points, const Face_list& polygons,
                                   const std::vector<std::size_t>& sources, const Options& options,
                                   const Distances_function& function)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute(
      [&] { return geodesic_distances(points, polygons, sources, options, function); });
  const Repaired_surface_3 repaired = repair_surface(points, polygons);
  const std::size_t none = repaired.origins.size();
  const std::vector<std::size_t> copies = internal::first_copies(repaired);
  std::vector<std::size_t> from = internal::sources_on_surface(sources, copies, none);
  const internal::Split_surface surface(repaired);
  const std::vector<std::size_t> doors = surface.doors();
  from.insert(from.end(), doors.begin(), doors.end());
  const auto number = static_cast<Eigen::Index>(sources.size());
  Eigen::MatrixXd distances = function ? internal::distances_by_function(surface, from, function)
                                       : internal::distances_on_surface(surface, from, options);
  if(surface.is_split())
  {
    const Eigen::MatrixXd from_doors = distances.rightCols(static_cast<Eigen::Index>(doors.size()));
    for(Eigen::Index j = 0; j < number; ++j)
      distances.col(j) = surface.extended(distances.col(j), from_doors);
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(
    static_cast<Eigen::Index>(copies.size()), number, (std::numeric_limits<double>::infinity)());
  for(std::size_t v = 0; v < copies.size(); ++v)
    if(copies[v] != none)
      result.row(static_cast<Eigen::Index>(v))
        = distances.row(static_cast<Eigen::Index>(copies[v])).head(number);
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
