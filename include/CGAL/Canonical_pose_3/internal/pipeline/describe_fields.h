// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_DESCRIBE_FIELDS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_DESCRIBE_FIELDS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Adds what is known of the distances to the summary of a target.
inline void describe_fields(const Landmark_fields_3& fields, Registration_summary::Target& summary)
{
  summary.landmarks = fields.landmarks.size();
  summary.covering_radius = fields.covering_radius;
  summary.max_geodesic = fields.distances.maxCoeff();
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_DESCRIBE_FIELDS_H
