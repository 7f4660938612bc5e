// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TARGET_HANDEDNESS_H
#define CGAL_CANONICAL_POSE_3_TARGET_HANDEDNESS_H

#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns a number that is positive if the target has the handedness of the canonical pose, and
negative if its mirror image has.

Distances do not distinguish a target from its mirror image. The choice must be the same for all
poses of a shape, so it must not depend on the pose, unlike the energy of the registration, which
moreover differs by little. The function returns the sum of two dimensionless numbers that depend
only on the target and change their sign under reflection:
- the volume enclosed by the surface in the target, relative to that in the input. It dominates for
  shapes such as quadrupeds (magnitude 1.2 to 2 over their poses), whose target is inside out if it
  is mirrored. It is set to 0 if the volume of the input is at most \f$ 10^{-6} A^{3/2} \f$, where
  \f$ A \f$ is its area, or within the error of rounding its coordinates: a flat sheet has no inside
  (a closed sheet of paper has, with \f$ 1.4 \cdot 10^{-4} A^{3/2} \f$);
- the third moment \f$ \sum m_i x_i y_i z_i \f$ along the principal axes of the target, the longest
  first, divided by the product of the standard deviations. It dominates for shapes such as humans
  (magnitude 0.9 to 1.4 over their poses), whose target is twisted: neither a twist nor its mirror
  image is inside out.

The volume of an open surface is that of the cone over it, with the mean of all points as apex.

If the number is close to 0 (for shapes whose target is its own mirror image, such as a bar), both
choices lead to about the same pose.

\param target \f$ n \times 3 \f$, target of each vertex.
\param points \f$ n \times 3 \f$, points of the input.
\param triangles triples of rows, oriented.
\param weights \f$ n \f$ nonnegative weights, for instance `vertex_area_shares()`.

Target and input may be in any unit, the same for both.

\pre The numbers of rows agree, all coordinates are finite, and the sum of the weights is positive.

<em>Complexity:</em> linear.

\sa `align_target()`
*/
double target_handedness(Point_matrix target, Point_matrix points,
                         const std::vector<std::array<std::size_t, 3>>& triangles,
                         const Eigen::VectorXd& weights);

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns `target_handedness()` for a target of the vertices of a triangle mesh, weighted by
`vertex_area_shares()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and points of
        a kernel as values
*/
template <class TriangleMesh, class VertexPointMap>
double target_handedness(const Point_matrix& target, const TriangleMesh& tmesh,
                         VertexPointMap vertex_point_map)
{
  const Point_matrix points = point_matrix(tmesh, vertex_point_map);
  const auto triangles = internal::index_triangles(tmesh);
  return target_handedness(target, points, triangles, vertex_area_shares(points, triangles));
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/target/target_handedness_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_TARGET_HANDEDNESS_H
