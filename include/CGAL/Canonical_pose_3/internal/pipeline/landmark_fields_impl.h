// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_LANDMARK_FIELDS_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_LANDMARK_FIELDS_IMPL_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/fields_of_function.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/solver_of_options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/with_geodesics.h>
#include <CGAL/Canonical_pose_3/internal/soup/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/target/check_number_of_landmarks.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

CGAL_CANONICAL_POSE_3_INLINE Landmark_fields_3 landmark_fields(const Surface_component_3& surface,
                                                               const Options& options)
{
  if(options.given.landmark_fields)
    return *options.given.landmark_fields;
  const internal::Thread_limit limit(options);
  internal::check_number_of_landmarks(options.number_of_landmarks,
                                      static_cast<std::size_t>(surface.points.rows()));
  if(options.landmark_fields_function)
    return internal::fields_of_function(options.landmark_fields_function, surface, options);
  const internal::Indexed_mesh mesh = internal::indexed_mesh(surface.points, surface.triangles);
  const internal::Indexed_mesh::Vertex_index first(
    static_cast<internal::Indexed_mesh::size_type>(internal::first_landmark(surface, options)));
  return internal::with_geodesics(
    mesh, options, internal::solver_of_options(options).lane_factor_maker(),
    [&](const auto& geodesics) {
      return front_landmarks(geodesics, options.number_of_landmarks, first);
    });
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_LANDMARK_FIELDS_IMPL_H
