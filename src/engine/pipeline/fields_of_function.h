// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_FIELDS_OF_FUNCTION_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_FIELDS_OF_FUNCTION_H

#include "../surface/without_degenerate_faces.h"

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/target/check_landmark_fields.h>

#include <CGAL/Random.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline std::size_t first_landmark(const Surface_component_3& surface, const Method_options& options)
{
  if(options.random_seed == 0)
    return extremal_point(surface.points, surface.triangles);
  return static_cast<std::size_t>(
    Random(options.random_seed)
      .get_int(0, static_cast<int>(surface.added.empty()
                                     ? static_cast<std::size_t>(surface.points.rows())
                                     : surface.origins.size())));
}

// The result of a user-defined function; throws `std::invalid_argument` unless it consists of
// distances on the surface, and `std::logic_error` unless they are to the given landmarks, if any.
inline Landmark_fields_3 fields_of_function(const Landmark_fields_function& function,
                                            const Surface_component_3& surface,
                                            const Method_options& options,
                                            const std::vector<std::size_t>& landmarks = {})
{
  Landmark_fields_3 fields = with_faces_of_input(surface.face_of_triangle, [&] {
    return function(without_degenerate_faces(surface.points, surface.triangles), surface.triangles,
                    options.number_of_landmarks, first_landmark(surface, options), landmarks);
  });
  check_landmark_fields(fields, static_cast<std::size_t>(surface.points.rows()),
                        "the landmark fields that the function returned");
  if(!landmarks.empty() && fields.landmarks != landmarks)
    throw std::logic_error(
      "the landmark fields that the function returned have other landmarks than it was given");
  return fields;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_FIELDS_OF_FUNCTION_H
