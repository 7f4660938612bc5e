// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_DESCRIBE_FIELDS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_DESCRIBE_FIELDS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_DESCRIBE_FIELDS_H
