// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_RELIEF_IN_FRONT_H
#define CANONICAL_POSE_3_ENGINE_STANCE_RELIEF_IN_FRONT_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// How much more a head differs from an ellipsoid in front, where the face is, than at the back: the logarithm of the ratio of the
// mean deviations of normals. Rows of `frame`: left, up, front.
inline double relief_in_front(const Point_matrix& points,
                              const std::vector<std::array<std::size_t, 3>>& triangles_of_head,
                              const Eigen::Matrix3d& frame)
{
  constexpr double largest_offset = 1.2, least_depth = .3; // in standard deviations
  constexpr double smallest = .02;                         // of a smooth head
  const auto number = static_cast<Eigen::Index>(triangles_of_head.size());
  Point_matrix centers(number, 3), normals(number, 3);
  for(Eigen::Index i = 0; i < number; ++i)
  {
    const auto corner = [&](const std::size_t k) -> Eigen::Vector3d {
      return frame
             * points
                 .row(static_cast<Eigen::Index>(triangles_of_head[static_cast<std::size_t>(i)][k]))
                 .transpose();
    };
    centers.row(i) = (corner(0) + corner(1) + corner(2)).transpose() / 3;
    normals.row(i) = (corner(1) - corner(0)).cross(corner(2) - corner(0)).transpose();
  }
  const Eigen::VectorXd areas = normals.rowwise().norm();
  if(!(areas.sum() > 0))
    return 0;
  const Eigen::RowVector3d mean = areas.transpose() * centers / areas.sum();
  centers.rowwise() -= mean;
  const Eigen::Matrix3d covariance
    = centers.transpose() * areas.asDiagonal() * centers / areas.sum();
  if(!(covariance.determinant() > 0))
    return 0;
  const Eigen::Matrix3d inverse = covariance.inverse();
  const Eigen::RowVector3d deviations = covariance.diagonal().cwiseSqrt().transpose();
  std::array<double, 2> area = {0, 0}, relief = {0, 0}; // in front, at the back
  for(Eigen::Index i = 0; i < number; ++i)
  {
    const Eigen::Array3d at = centers.row(i).cwiseQuotient(deviations).transpose().array();
    if(!(areas[i] > 0) || std::abs(at[0]) > largest_offset || std::abs(at[1]) > largest_offset
       || std::abs(at[2]) < least_depth)
      continue;
    const std::size_t side = at[2] > 0 ? 0 : 1;
    area[side] += areas[i];
    relief[side] += areas[i] - normals.row(i).dot((centers.row(i) * inverse).normalized());
  }
  if(!(area[0] > 0) || !(area[1] > 0))
    return 0;
  return std::log((relief[0] / area[0] + smallest) / (relief[1] / area[1] + smallest));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_RELIEF_IN_FRONT_H
