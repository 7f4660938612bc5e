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

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/soup/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/soup/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/target/check_number_of_landmarks.h>

#include <CGAL/Random.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Landmarks on a component, and the distances to them.
inline Landmark_fields_3 component_fields(const Posed_component& component, const Options& options,
                                          const Lane_factor_maker lane_factor_maker)
{
  const std::size_t n = static_cast<std::size_t>(component.points.rows());
  check_number_of_landmarks(options.number_of_landmarks, n);
  const Indexed_mesh mesh = indexed_mesh(component.points, component.triangles);
  std::size_t first = extremal_point(component.points, component.triangles);
  if(options.random_seed != 0)
    first = static_cast<std::size_t>(
      Random(options.random_seed).get_int(0, static_cast<int>(component.points.rows())));
  const Indexed_mesh::Vertex_index vertex(static_cast<Indexed_mesh::size_type>(first));
  switch(options.geodesics)
  {
  case Options::Geodesics::EXACT: // they take longer than all the rest, and a batch saves nothing
    return with_faces_of_input(component.faces, [&] {
      return farthest_point_landmarks(Exact_geodesics_3<Indexed_mesh>(mesh),
                                      options.number_of_landmarks, vertex);
    });
  case Options::Geodesics::WAVEFRONT:
    return front_landmarks(Wavefront_geodesics_3<Indexed_mesh>(mesh), options.number_of_landmarks,
                           vertex);
  default:
    return front_landmarks(
      Heat_geodesics_3<Indexed_mesh>(mesh, get(vertex_point, mesh), {}, lane_factor_maker),
      options.number_of_landmarks, vertex);
  }
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_FIELDS_H
