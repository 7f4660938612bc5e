// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_ALIGN_HANDEDNESS_H
#define CGAL_CANONICAL_POSE_3_ALIGN_HANDEDNESS_H

#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <Eigen/Core>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief finds the poses of a shape that are mirror images of most of the others.

The handedness of a single pose is not always certain, see
`Registration_summary::Target::is_handedness_certain`; for several poses of the same shape with
corresponding vertices, it can be made consistent: compute the poses that are found once more, with
the opposite value of `Method_options::takes_mirror_image`. (To reflect their coordinates would turn
them inside out.)

Two poses have the same handedness if their `pose_difference()` is smaller than that of one of them
and the mirror image of the other one. If this is contradictory for three or more poses, the choice
is changed for one pose after the other, until no change increases the sum of the advantages.

\param poses at least one matrix, all with the same number of rows.

\returns for each pose, whether it has the other handedness than most of the poses; among equally
         many, than the first one.

\throws std::invalid_argument as `pose_difference()`, and if there is no pose.

<em>Complexity:</em> quadratic in the number of poses, linear in the number of points.

\sa `target_handedness()`
*/
inline std::vector<bool> align_handedness(const std::vector<Point_matrix>& poses)
{
  if(poses.empty())
    throw std::invalid_argument("there is no pose");
  const auto k = static_cast<Eigen::Index>(poses.size());
  std::vector<Point_matrix> units;
  for(const Point_matrix& pose : poses)
  {
    internal::check_poses_correspond(pose, poses.front());
    units.push_back(internal::in_unit_of_gyration(pose));
  }
  const auto difference = [&](const Eigen::Index i, const Eigen::Index j, const bool is_mirrored) {
    return internal::difference_after_alignment(units[static_cast<std::size_t>(i)],
                                                units[static_cast<std::size_t>(j)], is_mirrored);
  };
  Eigen::MatrixXd advantages = Eigen::MatrixXd::Zero(k, k); // of the same handedness
  for(Eigen::Index i = 0; i < k; ++i)
    for(Eigen::Index j = 0; j < i; ++j)
      advantages(i, j) = advantages(j, i) = difference(i, j, true) - difference(i, j, false);
  Eigen::VectorXd signs
    = advantages.col(0).unaryExpr([](const double a) { return a < -1e-12 ? -1. : 1.; });
  for(bool has_changed = true; has_changed;)
  {
    has_changed = false;
    for(Eigen::Index i = 0; i < k; ++i)
      if(signs[i] * advantages.col(i).dot(signs) < -1e-12)
      {
        signs[i] = -signs[i];
        has_changed = true;
      }
  }
  const double most = signs.sum() != 0 ? signs.sum() : signs[0];
  std::vector<bool> result;
  for(Eigen::Index i = 0; i < k; ++i)
    result.push_back(signs[i] * most < 0);
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_ALIGN_HANDEDNESS_H
