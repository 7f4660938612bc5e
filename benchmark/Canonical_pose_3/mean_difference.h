// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_MEAN_DIFFERENCE_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_MEAN_DIFFERENCE_H

#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;

/// mean difference of all pairs of poses; NaN if there is none, or the points do not correspond
inline double mean_difference(const std::vector<Point_matrix>& poses)
{
  try
  {
    return CGAL::Canonical_pose_3::mean_pose_difference(poses);
  }
  catch(const std::invalid_argument&)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_MEAN_DIFFERENCE_H
