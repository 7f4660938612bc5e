// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_method_options.h"
#include "describe_fields.h"
#include "interpolated_fields.h"
#include "../support/Thread_limit.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Elastic_body_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/cell_stiffness.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/body_of_surface.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The result of a user-defined function; throws `std::invalid_argument` unless its surface is that
// of the component.
inline Elastic_body_3 checked_body(Elastic_body_3 body, const Eigen::Index n)
{
  if(body.embedding().rows() != n)
    throw std::invalid_argument("the function of the body returned one with "
                                + std::to_string(body.embedding().rows())
                                + " surface vertices for a surface of " + std::to_string(n));
  return body;
}

// Only the body, its kind and warnings.
inline Surface_body_3 requested_body(const Surface_component_3& surface,
                                     const Coarse_surface_3& coarse,
                                     const Landmark_fields_3& fields,
                                     const Component_options& options, const Body_makers& bodies)
{
  const Point_matrix& points = surface.points;
  const std::vector<Index_triangle>& triangles = surface.triangles;
  std::vector<std::string> warnings;
  const auto of_kind = [&](const char* const kind, Elastic_body_3 body) {
    return Surface_body_3{kind, std::move(body),    length_scale(fields, options), {},
                          {},   std::move(warnings)};
  };
  if(options.make_body)
    return of_kind("given", checked_body(options.make_body(points, triangles,
                                                           interpolated_fields(coarse, fields)),
                                         points.rows()));
  if(options.body == Options::Body::MESH_3)
  {
    if(bodies.mesh_3 == nullptr)
      throw std::runtime_error("the program was built without bodies of Mesh_3");
    return of_kind("mesh_3", bodies.mesh_3(points, triangles, fields.distances.maxCoeff(),
                                           options.lattice_spacing));
  }
  if(options.body == Options::Body::TETGEN)
  {
    if(bodies.tetgen == nullptr)
      throw std::runtime_error("the program was built without TetGen");
    try
    {
      return of_kind("tetgen", bodies.tetgen(points, triangles));
    }
    catch(const std::runtime_error& error)
    {
      warnings.push_back(error.what() + std::string("; the lattice took its place"));
    }
  }
  Geodesic_bounds bounds(fields.distances, fields.distances.maxCoeff());
  bounds.interpolate(coarse);
  return of_kind("lattice",
                 Lattice_body_3(points, triangles, std::move(bounds), options.lattice_spacing,
                                surface.caps, surface.share_of_cells));
}

Surface_body_3 body_of_surface(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                               const Landmark_fields_3& fields, const Component_options& options,
                               const Body_makers& bodies)
{
  check_method_options(options);
  if(const Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return body_of_surface(surface, coarse, fields, options, bodies); });
  CANONICAL_POSE_3_PRECONDITION(coarse.number_of_surface_vertices()
                                == static_cast<std::size_t>(surface.points.rows()));
  CANONICAL_POSE_3_PRECONDITION(fields.distances.rows() == coarse.surface.points.rows());
  Surface_body_3 result = requested_body(surface, coarse, fields, options, bodies);
  result.surface_vertices.resize(static_cast<std::size_t>(surface.points.rows()));
  std::iota(result.surface_vertices.begin(), result.surface_vertices.end(), std::size_t(0));
  if(options.stiffness.size() > 0)
    result.stiffness = cell_stiffness(
      result.body, vertex_area_shares(surface.points, surface.triangles), options.stiffness);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
