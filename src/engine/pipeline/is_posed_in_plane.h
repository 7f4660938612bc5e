// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_IS_POSED_IN_PLANE_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_IS_POSED_IN_PLANE_H

#include "../surface/planar.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Constraints_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline bool has_constraints(const Constraints_3& constraints)
{
  return !constraints.springs.empty() || !constraints.directions.empty()
         || !constraints.handles.empty() || !constraints.symmetric_pairs.empty()
         || constraints.function;
}

// Whether the pose of a surface should be planar like it, if that does not fold it. Distances do not tell: where a
// planar surface is not convex, they have less stress in space. Those of the caller may be of a curved surface.
inline bool is_posed_in_plane(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                              const Landmark_fields_3& fields, const Component_options& options)
{
  constexpr double tolerance = 1e-3;
  if(options.target_mode != Options::Target_mode::MDS
     || options.kernel != Options::Kernel::CLASSICAL || options.mds_kernel || options.paper_weights
     || options.target_fields_function || options.given.target
     || has_constraints(options.constraints) || !is_planar(surface.points, surface.triangles))
    return false;
  if(!options.given.landmark_fields)
    return true;
  const Landmark_fields_3 measured = landmark_fields(coarse.surface, fields.landmarks, options);
  return (measured.distances - fields.distances).cwiseAbs().maxCoeff()
         <= tolerance * measured.distances.maxCoeff();
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_IS_POSED_IN_PLANE_H
