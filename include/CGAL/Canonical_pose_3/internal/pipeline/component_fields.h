// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_FIELDS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_FIELDS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/with_geodesics.h>
#include <CGAL/Canonical_pose_3/internal/soup/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/soup/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/target/check_number_of_landmarks.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// What a function of the user returned; throws `std::invalid_argument` unless it is of use.
inline Landmark_fields_3 checked_fields(Landmark_fields_3 fields, const std::size_t n)
{
  const Eigen::MatrixXd& distances = fields.distances;
  if(distances.cols() == 0 || distances.rows() != static_cast<Eigen::Index>(n))
    throw std::invalid_argument(
      "the function of the landmark fields returned " + std::to_string(distances.rows()) + " x "
      + std::to_string(distances.cols()) + " distances on " + std::to_string(n) + " points");
  if(!distances.allFinite() || !(distances.array() >= 0).all())
    throw std::invalid_argument(
      "the function of the landmark fields returned a distance that is negative or not finite");
  if(fields.landmarks.size() != static_cast<std::size_t>(distances.cols())
     || std::any_of(fields.landmarks.begin(), fields.landmarks.end(),
                    [n](const std::size_t landmark) { return landmark >= n; }))
    throw std::invalid_argument(
      "the function of the landmark fields returned other landmarks than one point per column");
  return fields;
}

// Landmarks on a component, and the distances to them.
inline Landmark_fields_3 component_fields(const Posed_component& component, const Options& options,
                                          const Lane_factor_maker lane_factor_maker)
{
  const std::size_t n = static_cast<std::size_t>(component.points.rows());
  check_number_of_landmarks(options.number_of_landmarks, n);
  std::size_t first = extremal_point(component.points, component.triangles);
  if(options.random_seed != 0)
    first = static_cast<std::size_t>(
      Random(options.random_seed).get_int(0, static_cast<int>(component.points.rows())));
  if(options.landmark_fields_function)
    return checked_fields(with_faces_of_input(component.faces,
                                              [&] {
                                                return options.landmark_fields_function(
                                                  component.points, component.triangles,
                                                  options.number_of_landmarks, first);
                                              }),
                          n);
  const Indexed_mesh mesh = indexed_mesh(component.points, component.triangles);
  const Indexed_mesh::Vertex_index vertex(static_cast<Indexed_mesh::size_type>(first));
  return with_geodesics(mesh, options, lane_factor_maker, [&](const auto& geodesics) {
    return front_landmarks(geodesics, options.number_of_landmarks, vertex);
  });
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_FIELDS_H
