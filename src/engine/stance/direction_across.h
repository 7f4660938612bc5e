// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_DIRECTION_ACROSS_H
#define CANONICAL_POSE_3_ENGINE_STANCE_DIRECTION_ACROSS_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The unit normal of the plane in which the mirror image of points is nearest to them, near `left`, a unit vector; `left` itself if
// other planes are nearly as good, or if it is not within 60 degrees.
Eigen::Vector3d direction_across(const Point_matrix& points, const Eigen::Vector3d& left);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_DIRECTION_ACROSS_H
