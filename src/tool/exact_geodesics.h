// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_EXACT_GEODESICS_H
#define CGAL_CANONICAL_POSE_3_TOOL_EXACT_GEODESICS_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

// Compiled separately, since it takes long: exact distances.

namespace Canonical_pose_tool {

CGAL::Canonical_pose_3::Landmark_fields_function exact_landmark_fields();

// See CGAL::Canonical_pose_3::Distances_function.
Eigen::MatrixXd exact_distances(const CGAL::Canonical_pose_3::Point_matrix& points,
                                const std::vector<std::array<std::size_t, 3>>& triangles,
                                const std::vector<std::size_t>& sources);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_EXACT_GEODESICS_H
