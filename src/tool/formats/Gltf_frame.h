// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_GLTF_FRAME_H
#define CGAL_CANONICAL_POSE_3_TOOL_GLTF_FRAME_H

#include "Shown_surface.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace Canonical_pose_tool {

inline constexpr double LARGEST_FLOAT = (std::numeric_limits<float>::max)();

inline float to_float(const double x)
{
  return static_cast<float>((std::min)((std::max)(x, -LARGEST_FLOAT), LARGEST_FLOAT));
}

// Where a file has its origin, and its unit of length.
struct Gltf_frame
{
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
  double unit = 1;

  // A coordinate in the unit of the file.
  double stored(const CGAL::Canonical_pose_3::Point_matrix& points, const std::size_t vertex,
                const int k) const
  {
    return (points(static_cast<Eigen::Index>(vertex), k) - center[k]) / unit;
  }
};

// The origin is moved only if the surface is far from it, where single precision is coarse, or if differences to the other
// shapes are integers. Throws std::invalid_argument if it cannot be represented.
inline Gltf_frame frame_of(const CGAL::Canonical_pose_3::Point_matrix& points,
                           const std::vector<Other_shape>& other_shapes, const bool is_quantized)
{
  Gltf_frame frame;
  const Eigen::RowVector3d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  const Eigen::RowVector3d center = 0.5 * low + 0.5 * high;
  const double radius = (0.5 * high - 0.5 * low).maxCoeff();
  const double many_radii = 8;
  if(is_quantized || center.cwiseAbs().maxCoeff() > many_radii * radius)
    frame.center = center;
  const double largest = (points.rowwise() - frame.center).cwiseAbs().maxCoeff();
  const double least_radius
    = (std::numeric_limits<float>::min)() / std::numeric_limits<float>::epsilon();
  if(!(largest <= LARGEST_FLOAT) || (radius > 0 && radius < least_radius))
    throw std::invalid_argument(
      "the surface is too large or too small for glTF, which has single precision");
  if(!is_quantized)
    return frame;
  double farthest = 0;
  for(const Other_shape& shape : other_shapes)
    farthest = (std::max)(farthest, (shape.points - points).cwiseAbs().maxCoeff());
  const double largest_short = 32767;
  if(farthest > 0) // of single precision, as a skin has it
    frame.unit
      = (std::max)(to_float(farthest / largest_short), (std::numeric_limits<float>::min)());
  return frame;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_GLTF_FRAME_H
