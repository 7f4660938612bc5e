// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_SURFACE_MEASURES_H
#define CGAL_CANONICAL_POSE_3_SURFACE_MEASURES_H

#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the share of each vertex in the area of a surface, one third of the area of its
triangles. The sum is 1.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.

\throws std::invalid_argument if the area is zero or overflows.
*/
inline Eigen::VectorXd vertex_area_shares(const Point_matrix& points,
                                          const std::vector<std::array<std::size_t, 3>>& triangles)
{
  const double unit = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0;
  Eigen::VectorXd area = Eigen::VectorXd::Zero(points.rows());
  for(const auto& t : triangles)
  {
    const Eigen::Vector3d e = (points.row(t[1]) - points.row(t[0])) / unit;
    const Eigen::Vector3d f = (points.row(t[2]) - points.row(t[0])) / unit;
    const double third = e.cross(f).norm() / 6;
    for(const std::size_t v : t)
      area[static_cast<Eigen::Index>(v)] += third;
  }
  const double sum = area.sum();
  if(!(sum > 0) || !std::isfinite(sum))
    throw std::invalid_argument("the surface has no area");
  return area / sum;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the share of each vertex in the area of a triangle mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and points
       of a kernel as values
*/
template <class TriangleMesh, class VertexPointMap>
Eigen::VectorXd vertex_area_shares(const TriangleMesh& tmesh, VertexPointMap vertex_point_map)
{
  return vertex_area_shares(point_matrix(tmesh, vertex_point_map),
                            internal::index_triangles(tmesh));
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the median of \f$ |\log(l'/l)| \f$ over the edges, where \f$ l \f$ and \f$ l' \f$ are
the lengths of an edge at rest and in the pose. Edges of length 0 at rest are ignored.

\param rest \f$ n \times 3 \f$, positions at rest.
\param pose \f$ n \times 3 \f$, positions in the pose.
\param triangles triples of rows.
*/
inline double median_edge_strain(const Point_matrix& rest, const Point_matrix& pose,
                                 const std::vector<std::array<std::size_t, 3>>& triangles)
{
  internal::Buckets<std::size_t> larger_ends(
    static_cast<std::size_t>(rest.rows()), [&](const auto& put) {
      for(const auto& t : triangles)
        for(int k = 0; k < 3; ++k)
          put((std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3]));
    });
  std::vector<double> strains;
  for(std::size_t v = 0; v < larger_ends.number_of_buckets(); ++v)
  {
    const auto ends = larger_ends[v];
    std::sort(ends.begin(), ends.end());
    const auto last = std::unique(ends.begin(), ends.end());
    for(auto w = ends.begin(); w != last; ++w)
    {
      const double length = (rest.row(v) - rest.row(*w)).norm();
      if(length > 0)
        strains.push_back(std::abs(std::log((pose.row(v) - pose.row(*w)).norm() / length)));
    }
  }
  if(strains.empty())
    return 0;
  const auto middle = strains.begin() + static_cast<std::ptrdiff_t>(strains.size() / 2);
  std::nth_element(strains.begin(), middle, strains.end());
  return *middle;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SURFACE_MEASURES_H
