// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_DESCRIPTORS_DEPTH_IMAGE_H
#define CANONICAL_POSE_3_ENGINE_DESCRIPTORS_DEPTH_IMAGE_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The depths of triangles in the unit ball, seen from a direction by orthographic projection: 1 at
// the near side of the ball, 0 at its far side and where nothing is.
inline Eigen::VectorXd depth_image(const Point_matrix& points,
                                   const std::vector<Index_triangle>& triangles,
                                   const Eigen::Vector3d& direction, const Eigen::Index width)
{
  Eigen::Matrix3d frame;
  frame.col(0) = direction.unitOrthogonal();
  frame.col(1) = direction.cross(frame.col(0));
  frame.col(2) = direction;
  const Point_matrix seen = points * frame;
  const double scale = static_cast<double>(width) / 2;
  const auto column = [](const std::size_t v) { return static_cast<Eigen::Index>(v); };
  Eigen::VectorXd image = Eigen::VectorXd::Zero(width * width);
  for(const Index_triangle& t : triangles)
  {
    // In pixels; their centers are at integers.
    std::array<Eigen::Vector2d, 3> corners;
    for(std::size_t k = 0; k < 3; ++k)
      corners[k] = (scale * (seen.row(column(t[k])).head<2>().array() + 1) - .5).transpose();
    const auto range = [&](const int axis) {
      const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      return std::array<Eigen::Index, 2>{
        (std::max)(static_cast<Eigen::Index>(std::ceil(low)), Eigen::Index(0)),
        (std::min)(static_cast<Eigen::Index>(std::floor(high)), width - 1)};
    };
    const Eigen::Vector2d a = corners[1] - corners[0], b = corners[2] - corners[0];
    const double area = a.x() * b.y() - a.y() * b.x();
    if(area == 0)
      continue;
    const auto [first_column, last_column] = range(0);
    const auto [first_row, last_row] = range(1);
    for(Eigen::Index y = first_row; y <= last_row; ++y)
      for(Eigen::Index x = first_column; x <= last_column; ++x)
      {
        const Eigen::Vector2d p
          = Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y)) - corners[0];
        const double u = (p.x() * b.y() - p.y() * b.x()) / area;
        const double v = (a.x() * p.y() - a.y() * p.x()) / area;
        if(u < 0 || v < 0 || u + v > 1)
          continue;
        const double depth = (1 - u - v) * seen(column(t[0]), 2) + u * seen(column(t[1]), 2)
                             + v * seen(column(t[2]), 2);
        double& pixel = image[y * width + x];
        pixel = (std::max)(pixel, (1 + depth) / 2);
      }
  }
  return image;
}

} // namespace internal

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_DESCRIPTORS_DEPTH_IMAGE_H
