// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_ENCLOSED_VOLUME_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_ENCLOSED_VOLUME_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace Canonical_pose_benchmark {

/// The volume inside a closed surface, which may be non-manifold; `caps`: triangles that close it.
inline double enclosed_volume(const CGAL::Canonical_pose_3::Point_matrix& points,
                              const std::vector<std::array<std::size_t, 3>>& triangles,
                              const std::vector<std::array<std::size_t, 3>>& caps)
{
  const Eigen::RowVector3d center = points.colwise().mean();
  double sum = 0;
  for(const auto* const soup : {&triangles, &caps})
    for(const auto& t : *soup)
    {
      Eigen::Matrix3d corners;
      for(std::size_t k = 0; k < 3; ++k)
        corners.row(static_cast<Eigen::Index>(k))
          = points.row(static_cast<Eigen::Index>(t[k])) - center;
      sum += corners.determinant() / 6;
    }
  return sum;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_ENCLOSED_VOLUME_H
