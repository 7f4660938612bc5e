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
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The length scale L: the largest distance; or, without a target, for which few landmarks suffice,
// the largest one from the first two landmarks. The second one is the vertex farthest from the first.
inline double length_scale(const Landmark_fields_3& fields, const Method_options& options)
{
  constexpr Eigen::Index two = 2;
  return options.target_mode == Options::Target_mode::UNFOLDING
           ? fields.distances.leftCols((std::min)(two, fields.distances.cols())).maxCoeff()
           : fields.distances.maxCoeff();
}

// Adds what is known of the distances to the summary of a target.
inline void describe_fields(const Landmark_fields_3& fields, const Method_options& options,
                            Registration_summary::Target& summary)
{
  summary.landmarks = fields.landmarks.size();
  summary.covering_radius = fields.covering_radius;
  summary.max_geodesic = length_scale(fields, options);
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_DESCRIBE_FIELDS_H
