// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_MIRROR_PLANE_NORMAL_H
#define CANONICAL_POSE_3_ENGINE_STANCE_MIRROR_PLANE_NORMAL_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The unit normal of the plane in which the mirror image of points is nearest to them; `left` itself if others are nearly as
// good. It is turned by up to 84 degrees from `left` about `up`, and tilted by up to 48. `left` and `up`: orthogonal unit vectors.
Eigen::Vector3d mirror_plane_normal(const Point_matrix& points, const Eigen::Vector3d& left,
                                    const Eigen::Vector3d& up);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_MIRROR_PLANE_NORMAL_H
