// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_INTRINSIC_SYMMETRY_H
#define CANONICAL_POSE_3_ENGINE_TARGET_INTRINSIC_SYMMETRY_H

#include <CGAL/Canonical_pose_3/Intrinsic_symmetry_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The symmetry of a pose that is clear, but for the identity. `pose`: one row per row of the distances. An orthogonal map of the
// embedding by more than three eigenvectors of multidimensional scaling is fitted to a rotation or reflection of the pose (cf.
// Ovsjanikov, Sun and Guibas, "Global intrinsic symmetries of shapes", 2008).
std::optional<Intrinsic_symmetry_3> symmetry_of_pose(const Landmark_fields_3& fields,
                                                     const Point_matrix& pose,
                                                     const Eigen::VectorXd& shares);

// The mean of a pose and of its image, which is moved next to it by a rotation or a reflection.
Point_matrix symmetric_pose(const Point_matrix& pose, const std::vector<std::size_t>& images,
                            const Eigen::VectorXd& shares);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_INTRINSIC_SYMMETRY_H
