// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_POSE_DIFFERENCE_H
#define CGAL_CANONICAL_POSE_3_POSE_DIFFERENCE_H

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Scales the points such that the root mean square distance to their centroid is 1.
inline Point_matrix in_unit_of_gyration(Point_matrix points)
{
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    if(!points.row(i).allFinite())
      throw std::invalid_argument("point " + std::to_string(i)
                                  + " has a coordinate that is not finite");
  normalize(points); // so that squares neither vanish nor overflow
  points.rowwise() -= points.colwise().mean().eval();
  const double radius = std::sqrt(points.rowwise().squaredNorm().mean());
  if(!(radius > 0))
    throw std::invalid_argument("all points are at the same position");
  return points / radius;
}

inline double difference_after_alignment(const Point_matrix& a, const Point_matrix& b,
                                         const bool is_mirrored)
{
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(a.rows());
  return std::sqrt((align_target(a, b, weights, is_mirrored) - b).rowwise().squaredNorm().mean());
}

inline double difference_of_unit_poses(const Point_matrix& a, const Point_matrix& b,
                                       const bool may_be_reflected)
{
  const double difference = difference_after_alignment(a, b, false);
  return may_be_reflected ? (std::min)(difference, difference_after_alignment(a, b, true))
                          : difference;
}

inline void check_poses_correspond(const Point_matrix& a, const Point_matrix& b)
{
  if(a.rows() != b.rows() || a.rows() == 0)
    throw std::invalid_argument("poses of " + std::to_string(a.rows()) + " and "
                                + std::to_string(b.rows()) + " points cannot be compared");
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns how much two poses of corresponding points differ, independently of their position,
orientation and scale.

It is the root mean square distance of corresponding points after the best rigid motion
\cgalCite{cgal:canonical-k-sbrrsv-76}; both poses are first scaled to a radius of gyration (root
mean square distance to the centroid) of 1. The value is 0 for congruent poses and at most
\f$ \sqrt 2 \f$.

\param a \f$ n \times 3 \f$, one pose.
\param b \f$ n \times 3 \f$, the other one.
\param may_be_reflected whether a mirror image is considered to be the same pose: the smaller
       difference of `a` and of its mirror image is returned.

\throws std::invalid_argument if the numbers of points differ or are 0, a coordinate is not finite, or all points of a
       pose are at the same position.

<em>Complexity:</em> linear.

\sa `mean_pose_difference()`
*/
inline double pose_difference(const Point_matrix& a, const Point_matrix& b,
                              const bool may_be_reflected = false)
{
  internal::check_poses_correspond(a, b);
  return internal::difference_of_unit_poses(internal::in_unit_of_gyration(a),
                                            internal::in_unit_of_gyration(b), may_be_reflected);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the mean of `pose_difference()` over all pairs of poses.

\param poses at least two matrices with the same number of rows.
\param may_be_reflected see `pose_difference()`; applied to each pair independently.

\throws std::invalid_argument as `pose_difference()`, and if there are fewer than two poses.
*/
inline double mean_pose_difference(const std::vector<Point_matrix>& poses,
                                   const bool may_be_reflected = false)
{
  if(poses.size() < 2)
    throw std::invalid_argument("it takes two poses to compare");
  std::vector<Point_matrix> units;
  for(const Point_matrix& pose : poses)
  {
    internal::check_poses_correspond(pose, poses.front());
    units.push_back(internal::in_unit_of_gyration(pose));
  }
  double sum = 0;
  for(std::size_t i = 0; i < units.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      sum += internal::difference_of_unit_poses(units[i], units[j], may_be_reflected);
  return sum / (static_cast<double>(poses.size()) * static_cast<double>(poses.size() - 1) / 2);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_POSE_DIFFERENCE_H
