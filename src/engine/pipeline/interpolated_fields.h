// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_INTERPOLATED_FIELDS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_INTERPOLATED_FIELDS_H

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Distances at the vertices of the surface, given those at the vertices of the coarse surface.
inline Landmark_fields_3 interpolated_fields(const Coarse_surface_3& coarse,
                                             const Landmark_fields_3& fields)
{
  Landmark_fields_3 result;
  result.covering_radius = fields.covering_radius;
  result.distances = coarse.interpolated(fields.distances);
  for(const std::size_t landmark : fields.landmarks)
    result.landmarks.push_back(coarse.vertices[landmark]);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_INTERPOLATED_FIELDS_H
