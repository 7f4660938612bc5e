// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_SIDE_OF_NEAREST_FACE_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_SIDE_OF_NEAREST_FACE_H

#include "Surface_rays.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Determines whether points are behind the nearest of a few faces. If an edge or a vertex is
// nearest, its faces are equally near, and the one that faces the point most directly is used.
class Side_of_nearest_face
{
public:
  // `tolerance`: distances that differ by less are considered equal.
  Side_of_nearest_face(const Row_points& points, const std::vector<Index_triangle>& triangles,
                       const std::vector<int>& faces, const double tolerance)
    : m_tolerance(tolerance)
  {
    for(const int f : faces)
    {
      const Index_triangle& t = triangles[static_cast<std::size_t>(f)];
      const Eigen::Vector3d a = points.row(static_cast<Eigen::Index>(t[0])),
                            b = points.row(static_cast<Eigen::Index>(t[1])),
                            c = points.row(static_cast<Eigen::Index>(t[2]));
      const Eigen::Vector3d normal = (b - a).cross(c - a).stableNormalized();
      if(normal.isZero(0))
        continue; // a face without area has no side; its neighbors are equally near
      const Eigen::Vector3d centroid = (a + b + c) / 3;
      const double radius
        = std::sqrt((std::max)({(a - centroid).squaredNorm(), (b - centroid).squaredNorm(),
                                (c - centroid).squaredNorm()}));
      m_faces.push_back({centroid, normal, radius, {cgal_point(a), cgal_point(b), cgal_point(c)}});
    }
  }

  bool is_behind(const Eigen::Vector3d& point)
  {
    double nearest = (std::numeric_limits<double>::max)();
    for(const Face& face : m_faces)
      nearest = (std::min)(nearest, (point - face.centroid).squaredNorm());
    nearest = std::sqrt(nearest);
    m_heights.clear();
    for(const Face& face : m_faces)
    {
      const double reach = nearest + face.radius + m_tolerance;
      if((point - face.centroid).squaredNorm() > reach * reach)
        continue;
      const auto q
        = Kernel().construct_projected_point_3_object()(face.triangle, cgal_point(point));
      const Eigen::Vector3d way = point - Eigen::Vector3d(q.x(), q.y(), q.z());
      m_heights.emplace_back(way.norm(), face.normal.dot(way));
      nearest = (std::min)(nearest, m_heights.back().first);
    }
    double height = 0;
    for(const auto& [distance, height_over_plane] : m_heights)
      if(distance <= nearest + m_tolerance && std::abs(height_over_plane) > std::abs(height))
        height = height_over_plane;
    return height < 0;
  }

private:
  using Kernel = Simple_cartesian<double>;

  struct Face
  {
    Eigen::Vector3d centroid, normal;
    double radius; // around the centroid
    Kernel::Triangle_3 triangle;
  };

  static Kernel::Point_3 cgal_point(const Eigen::Vector3d& p) { return {p[0], p[1], p[2]}; }

  double m_tolerance;
  std::vector<Face> m_faces;
  std::vector<std::pair<double, double>> m_heights; // distance from a face, height over its plane
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_SIDE_OF_NEAREST_FACE_H
