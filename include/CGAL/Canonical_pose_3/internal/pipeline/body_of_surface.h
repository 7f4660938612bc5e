// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_BODY_OF_SURFACE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_BODY_OF_SURFACE_H

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// See `surface_body()`. Must not run in parallel with the distances: TetGen and METIS, which may be
// called by CHOLMOD, use the same std::rand().
Surface_body_3 body_of_surface(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                               const Landmark_fields_3& fields, const Component_options& options,
                               const Body_makers& bodies);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_BODY_OF_SURFACE_H
