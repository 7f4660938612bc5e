// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_RESULT_H
#define CGAL_CANONICAL_POSE_3_RESULT_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <optional>
#include <ostream>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds what `canonical_pose_3()` returns.

It inherits the members of `Intermediate_results`: the target and, if
`Options::return_landmark_fields` is set, the landmarks and the distances to them. Both can be given
to another call for the same input: `options.given = result`.
*/
struct Result : Intermediate_results
{
  /// the outcome, including iterations, energies and seconds per stage.
  Registration_summary summary;

  /// \f$ n \times 3 \f$, the pose of each vertex, in the order of `vertices(tmesh)`, of the points
  /// of a soup, or of the vertices of a complex. Empty unless `is_usable()`; the same is true for
  /// all other members except the summary.
  Point_matrix pose;

  /// \f$ m \times 3 \f$, the pose of `Options::followers`.
  Point_matrix pose_of_followers;

  /// the rigid motion from the frame of the input, to which the target refers, to that of the pose:
  /// the identity if it is positioned near the input.
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();

  /// the joints of the largest component, for a `Method_options::Stance`, `Vertex_options::limb_directions` or
  /// `Method_options::Frame::BODY`.
  std::optional<Skeleton_3> skeleton;

  /// returns whether there is a pose.
  bool is_usable() const { return summary.is_usable(); }

  /// returns the outcome in one line, see `Registration_summary::brief_report()`.
  std::string brief_report() const { return summary.brief_report(); }
};

/// \relates Result
/// writes `Result::brief_report()`.
inline std::ostream& operator<<(std::ostream& out, const Result& result)
{
  return out << result.brief_report();
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_RESULT_H
