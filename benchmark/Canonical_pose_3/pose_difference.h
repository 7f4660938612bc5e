// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_POSE_DIFFERENCE_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_POSE_DIFFERENCE_H

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;

/// root mean square distance of the points to their centroid
inline double radius_of_gyration(const Point_matrix& points)
{
  return std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean());
}

/// root mean square distance of corresponding points after the best rigid motion, without
/// reflection; both are first scaled to unit radius of gyration
inline double pose_difference(const Point_matrix& a, const Point_matrix& b)
{
  const Point_matrix unit_a = a / radius_of_gyration(a), unit_b = b / radius_of_gyration(b);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(a.rows());
  const Point_matrix moved = CGAL::Canonical_pose_3::align_target(unit_a, unit_b, weights);
  return std::sqrt((moved - unit_b).rowwise().squaredNorm().mean());
}

/// mean of `pose_difference()` over all pairs; NaN if there is none, or the points do not
/// correspond
inline double mean_pose_difference(const std::vector<Point_matrix>& poses)
{
  double sum = 0;
  std::size_t pairs = 0;
  for(std::size_t i = 0; i < poses.size(); ++i)
    for(std::size_t j = 0; j < i; ++j, ++pairs)
    {
      if(poses[i].rows() != poses[j].rows())
        return std::numeric_limits<double>::quiet_NaN();
      sum += pose_difference(poses[i], poses[j]);
    }
  return pairs > 0 ? sum / static_cast<double>(pairs) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_POSE_DIFFERENCE_H
