// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TARGET_3_H
#define CGAL_CANONICAL_POSE_3_TARGET_3_H

#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the target of a surface in its final position.

\sa `mds_target()`
*/
struct Target_3
{
  /// \f$ n \times 3 \f$, the target of each vertex of the surface.
  Point_matrix points;

  /// whether the target was given, see `Options::given`.
  bool is_given = false;

  /// how the target was computed.
  Registration_summary::Target summary;

  /// warnings of one line each, see `Registration_summary::warnings`.
  std::vector<std::string> warnings;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TARGET_3_H
