// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_BODY_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_BODY_H

#include <CGAL/Canonical_pose_3/Elastic_body_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/cell_stiffness.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

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

// The body of a component.
struct Component_body
{
  std::string kind;
  Elastic_body_3 body;
  // the surface vertex of the body that each vertex of the component is
  std::vector<std::size_t> origins;
  Eigen::VectorXd stiffness; // of the cells, or nothing
  std::vector<std::string> warnings;
};

// What a function of the user returned; throws `std::invalid_argument` unless its surface is that of the component.
inline Elastic_body_3 checked_body(Elastic_body_3 body, const Eigen::Index n)
{
  if(body.embedding().rows() != n)
    throw std::invalid_argument("the function of the body returned one with "
                                + std::to_string(body.embedding().rows())
                                + " surface vertices for a surface of " + std::to_string(n));
  return body;
}

// The body of a surface that the options request. Not to be made beside the distances: TetGen and METIS, which CHOLMOD
// may call, draw from the same std::rand(). `stiffness`: of the vertices, or nothing; `shares`: theirs in the area.
inline Component_body body_of_surface(const Posed_component& component,
                                      const Landmark_fields_3& fields,
                                      const Eigen::VectorXd& stiffness, const Options& options,
                                      const Body_makers& bodies, const Eigen::VectorXd& shares)
{
  const Point_matrix& points = component.points;
  const std::vector<Index_triangle>& triangles = component.triangles;
  std::vector<std::size_t> origins(static_cast<std::size_t>(points.rows()));
  std::iota(origins.begin(), origins.end(), std::size_t(0));
  const auto in_body
    = [&](const char* kind, Elastic_body_3 body, std::vector<std::string> warnings = {}) {
        Eigen::VectorXd of_cells;
        if(stiffness.size() > 0)
          of_cells = cell_stiffness(body, shares, stiffness);
        return Component_body{kind, std::move(body), std::move(origins), std::move(of_cells),
                              std::move(warnings)};
      };
  if(options.make_body)
    return in_body("given",
                   checked_body(options.make_body(points, triangles, fields), points.rows()));
  if(options.body == Options::Body::MESH_3)
  {
    if(bodies.mesh_3 == nullptr)
      throw std::runtime_error("the program was built without bodies of Mesh_3");
    return in_body("mesh_3", bodies.mesh_3(points, triangles, fields.distances.maxCoeff(),
                                           options.lattice_spacing));
  }
  std::vector<std::string> warnings;
  if(options.body == Options::Body::TETGEN)
  {
    if(bodies.tetgen == nullptr)
      throw std::runtime_error("the program was built without TetGen");
    try
    {
      return in_body("tetgen", bodies.tetgen(points, triangles));
    }
    catch(const std::runtime_error& error)
    {
      warnings.push_back(error.what() + std::string("; the lattice took its place"));
    }
  }
  return in_body(
    "lattice",
    Lattice_body_3(points, triangles, fields.distances, options.lattice_spacing, component.caps),
    std::move(warnings));
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_BODY_H
