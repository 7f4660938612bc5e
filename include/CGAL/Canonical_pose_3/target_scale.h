// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TARGET_SCALE_H
#define CGAL_CANONICAL_POSE_3_TARGET_SCALE_H

#include <CGAL/Canonical_pose_3/internal/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Twice the area of triangles, by the square of `unit`.
inline double twice_area(const Point_matrix& points,
                         const std::vector<std::array<std::size_t, 3>>& triangles,
                         const double unit)
{
  double sum = 0;
  for(const auto& t : triangles)
  {
    const auto corner
      = [&](const std::size_t k) { return points.row(static_cast<Eigen::Index>(t[k])); };
    const Eigen::Vector3d a = (corner(1) - corner(0)) / unit, b = (corner(2) - corner(0)) / unit;
    sum += a.cross(b).norm();
  }
  return sum;
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the factor by which the target of a compact shape is made smaller.

Straight distances in the target are fitted to geodesics, which lead around a compact body: a ball
becomes a larger ball. (Along limbs both agree, and the target has less area than the surface, since
limbs are squeezed.) Where the target has more area than the surface, by the ratio \f$ a > 1 \f$, the
factor is \f$ a^{-2/3} \f$, else 1. Bending changes neither area, so the factor does not depend on the
pose. The exponent \f$ -1/2 \f$ would make the areas of target and surface equal; but the registration
makes compact shapes rounder, too, and what is to be kept is their volume.

\param target \f$ n \times 3 \f$, target of each vertex.
\param points \f$ n \times 3 \f$, points of the input, not all the same.
\param triangles triples of rows.

\pre The numbers of rows agree.

<em>Complexity:</em> linear.

\sa `align_target()`
*/
inline double target_scale(const Point_matrix& target, const Point_matrix& points,
                           const std::vector<std::array<std::size_t, 3>>& triangles)
{
  CGAL_precondition(target.rows() == points.rows());
  const double unit = points.cwiseAbs().maxCoeff();
  const double ratio
    = internal::twice_area(target, triangles, unit) / internal::twice_area(points, triangles, unit);
  return ratio > 1 && std::isfinite(ratio) ? std::pow(ratio, -2. / 3) : 1;
}

/// \ingroup PkgCanonicalPose3Ref
/// \brief is `target_scale()` of a target of the vertices of a triangle mesh.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and points
///         of a kernel as values
template <typename TriangleMesh, typename VertexPointMap>
double target_scale(const Point_matrix& target, const TriangleMesh& tmesh,
                    VertexPointMap vertex_point_map)
{
  return target_scale(target, point_matrix(tmesh, vertex_point_map),
                      internal::index_triangles(tmesh));
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TARGET_SCALE_H
