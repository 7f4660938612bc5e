// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MEAN_POSE_H
#define CGAL_CANONICAL_POSE_3_MEAN_POSE_H

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the mean of poses, or of other shapes, with corresponding points, whatever their positions and
orientations are.

Each pose is moved rigidly so that the sum of squared distances to the mean is smallest, and the mean is that of the
moved poses (J. C. Gower, "Generalized Procrustes analysis", 1975). Both steps alternate until the mean changes by
less than \f$ 10^{-6} \f$ of its radius of gyration. Poses are neither reflected nor scaled.

\param poses at least one matrix, all with the same number of rows.

\returns the mean, at the position and in the orientation that are nearest to those of the first pose.

\throws std::invalid_argument if there is no pose, the numbers of points differ or are 0, or a coordinate is not finite.

<em>Complexity:</em> linear in the number of coordinates, for each of a few iterations.

\sa `pose_difference()`
\sa `match_surfaces()`
*/
inline Point_matrix mean_pose(std::vector<Point_matrix> poses)
{
  constexpr double largest_change = 1e-6;
  constexpr int most_iterations = 1000;
  if(poses.empty())
    throw std::invalid_argument("there is no pose");
  double largest = 0;
  for(const Point_matrix& pose : poses)
  {
    internal::check_poses_correspond(pose, poses.front());
    internal::check_finite(pose);
    largest = (std::max)(largest, pose.cwiseAbs().maxCoeff());
  }
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  for(Point_matrix& pose : poses) // so that squares neither vanish nor overflow
    internal::multiply_by_power_of_two(pose, -exponent);

  const auto radius_of = [](const Point_matrix& points) {
    return std::sqrt(points.rowwise().squaredNorm().mean());
  };
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(poses.front().rows());
  Point_matrix mean = poses.front();
  for(int i = 0; i < most_iterations; ++i)
  {
    const Point_matrix before = mean;
    mean.setZero();
    for(const Point_matrix& pose : poses)
      mean += align_target(pose, before, weights);
    mean /= static_cast<double>(poses.size());
    if(radius_of(mean - before)
       <= largest_change * radius_of(mean.rowwise() - mean.colwise().mean()))
      break;
  }
  mean = align_target(mean, poses.front(), weights);
  internal::multiply_by_power_of_two(mean, exponent);
  return mean;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MEAN_POSE_H
