// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_PLANAR_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_PLANAR_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether all points are in the plane of the largest triangle, up to 1e-6 of their size.
inline bool is_planar(Point_matrix points, const std::vector<Index_triangle>& triangles)
{
  constexpr double tolerance = 1e-6;
  normalize(points);
  const Index_triangle& largest = *std::max_element(
    triangles.begin(), triangles.end(), [&](const Index_triangle& s, const Index_triangle& t) {
      return twice_area(points, s) < twice_area(points, t);
    });
  const auto corner = [&](const std::size_t k) {
    return Eigen::Vector3d(points.row(static_cast<Eigen::Index>(largest[k])));
  };
  const Eigen::Vector3d origin = corner(0);
  const Eigen::Vector3d normal = (corner(1) - origin).cross(corner(2) - origin).stableNormalized();
  const Point_matrix relative = points.rowwise() - origin.transpose();
  return (relative * normal).cwiseAbs().maxCoeff() <= tolerance * relative.cwiseAbs().maxCoeff();
}

// Points projected onto the plane of their first two principal axes, in the coordinates of these. The
// third coordinate is exactly 0.
inline Point_matrix flattened(const Point_matrix& points, const Eigen::VectorXd& weights)
{
  const Principal_axes frame(points, weights);
  Point_matrix result = (points.rowwise() - frame.centroid) * frame.axes;
  result.col(2).setZero();
  return result;
}

inline Point_matrix projected(const Point_matrix& points, const Point_matrix& points_of_plane)
{
  const Principal_axes frame(points_of_plane, Eigen::VectorXd::Ones(points_of_plane.rows()));
  const Eigen::Vector3d normal = frame.axes.col(2);
  const Eigen::VectorXd heights = (points.rowwise() - frame.centroid) * normal;
  return points - heights * normal.transpose();
}

// Whether the triangles of a planar surface have one orientation, but for a thousandth of the area.
inline bool is_unfolded(const Point_matrix& points, const std::vector<Index_triangle>& triangles)
{
  constexpr double tolerance = 1e-3;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double areas = 0;
  for(const Index_triangle& t : triangles)
  {
    const Eigen::Vector3d a = points.row(static_cast<Eigen::Index>(t[0])),
                          b = points.row(static_cast<Eigen::Index>(t[1])),
                          c = points.row(static_cast<Eigen::Index>(t[2]));
    const Eigen::Vector3d area = (b - a).cross(c - a);
    sum += area;
    areas += area.norm();
  }
  return sum.norm() >= (1 - tolerance) * areas;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_PLANAR_H
