// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_3_H
#define CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_3_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds landmarks and the distances of all points to them.

It is what `front_landmarks()` and `farthest_point_landmarks()` return and what
`Landmark_mds_target_builder_3` embeds. The distances may as well come from elsewhere: nothing here
depends on a mesh.

\sa `farthest_point_landmarks()`
\sa `front_landmarks()`
\sa `Landmark_mds_target_builder_3`
*/
struct Landmark_fields_3
{
  /// the \f$ l \f$ landmarks, as numbers of points (of vertices in the order of `vertices(tmesh)`).
  std::vector<std::size_t> landmarks;

  /// \f$ n \times l \f$: entry \f$ (i, j) \f$ is the distance of point \f$ i \f$ to landmark \f$ j
  /// \f$, in the unit of the points.
  Eigen::MatrixXd distances;

  /// the largest distance of a point to its nearest landmark, in the unit of the points.
  double covering_radius = 0;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_3_H
