// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CANONICAL_FRAME_H
#define CGAL_CANONICAL_POSE_3_CANONICAL_FRAME_H

#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the rigid motion that brings weighted points into their own frame.

The centroid becomes the origin, and the principal axes become the axes of coordinates, the longest
first. The moment \f$ \sum_i w_i \, |p_i| \, p_i \f$ has positive coordinates along two of them, those
along which it is the largest; the direction of the remaining one, across which the shape is the most
symmetric, follows, since the frame is right-handed. Poses of the same shape lie on each other in this
frame, unless its variances along two axes nearly agree, or it is nearly symmetric across two axes: then
the posture decides between positions that differ by a half or a quarter turn. (The third moments depend
on the ends of limbs, and so on the posture.)

\param points \f$ n \times 3 \f$, positions.
\param weights nonnegative, one per point, for example `vertex_area_shares()`.

\pre There are as many weights as points.

\throws std::invalid_argument if a weight is negative or not finite, their sum is not positive, or a
       coordinate is not finite.

<em>Complexity:</em> \f$ O(n) \f$.

\sa `Method_options::frame`
*/
inline Eigen::Isometry3d canonical_frame(const Point_matrix& points, const Eigen::VectorXd& weights)
{
  CGAL_precondition(points.rows() == weights.size());
  for(Eigen::Index i = 0; i < weights.size(); ++i)
    if(!(weights[i] >= 0) || !std::isfinite(weights[i]))
      throw std::invalid_argument("weight " + std::to_string(i) + " is negative or not finite");
  const double sum = weights.sum();
  if(!(sum > 0) || !std::isfinite(sum))
    throw std::invalid_argument("the sum of the weights is not positive, or not finite");
  internal::check_finite(points);
  const double largest = points.cwiseAbs().maxCoeff();
  const double unit = largest > 0 ? largest : 1;
  const Point_matrix scaled = points / unit;
  internal::Principal_axes frame(scaled, weights);
  const Point_matrix centered = scaled.rowwise() - frame.centroid;
  const Eigen::RowVector3d moment
    = weights.cwiseProduct(centered.rowwise().norm()).transpose() * centered * frame.axes;
  for(Eigen::Index k = 0; k < 3; ++k)
    if(moment[k] < 0)
      frame.axes.col(k) *= -1;
  Eigen::Index least;
  moment.cwiseAbs().minCoeff(&least);
  if(frame.axes.determinant() < 0)
    frame.axes.col(least) *= -1;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = frame.axes.transpose();
  result.translation() = -unit * (frame.axes.transpose() * frame.centroid.transpose());
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CANONICAL_FRAME_H
