// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSES_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The part of canonical_pose_3() that works on points and indices, independent of their source.

Result pose_of_surface(const Point_matrix& points, const Face_list& polygons,
                       const Options& options, const Body_makers& bodies);

Result pose_of_complex(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                       const Options& options);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSES_H
