// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_FARTHEST_POINT_LANDMARKS_H
#define CGAL_CANONICAL_POSE_3_FARTHEST_POINT_LANDMARKS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the point that lies farthest from the centroid of area of a triangle soup.

The choice follows a rigid motion and a scaling of the points and, but for ties, does not depend on
their order; it is the default first landmark. Among points at equal distance the first is taken.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.

\pre `points` has at least one row.

<em>Complexity:</em> linear.

\sa `farthest_point_landmarks()`
*/
inline std::size_t extremal_point(const Point_matrix& points,
                                  const std::vector<std::array<std::size_t, 3>>& triangles)
{
  CGAL_precondition(points.rows() > 0);
  Eigen::RowVector3d weighted = Eigen::RowVector3d::Zero();
  double area = 0;
  for(const std::array<std::size_t, 3>& t : triangles)
  {
    const Eigen::Vector3d e = points.row(t[1]) - points.row(t[0]);
    const Eigen::Vector3d f = points.row(t[2]) - points.row(t[0]);
    const double a = e.cross(f).norm();
    weighted += a / 3 * (points.row(t[0]) + points.row(t[1]) + points.row(t[2]));
    area += a;
  }
  const Eigen::RowVector3d centroid
    = area > 0 ? (weighted / area).eval() : points.colwise().mean().eval();
  Eigen::Index farthest;
  (points.rowwise() - centroid).rowwise().squaredNorm().maxCoeff(&farthest);
  return static_cast<std::size_t>(farthest);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the vertex of a triangle mesh that lies farthest from the centroid of area, with which the one call
begins.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and points of a kernel as values

\throws std::invalid_argument if a coordinate is not finite or a face is no triangle.
*/
template <class TriangleMesh, class VertexPointMap>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor
extremal_vertex(const TriangleMesh& tmesh, VertexPointMap vertex_point_map)
{
  const std::size_t row
    = extremal_point(point_matrix(tmesh, vertex_point_map), internal::index_triangles(tmesh));
  return *std::next(vertices(tmesh).begin(), static_cast<std::ptrdiff_t>(row));
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief selects landmarks by farthest point sampling \cgalCite{cgal:canonical-elpz-fpsi-97} and
returns them with their distance fields.

Starting from `first`, the vertex farthest from all landmarks so far is added until there are `l`.
The result is deterministic; among vertices at equal distance the first in the order of
`vertices(tmesh)` is taken. Vertices that no landmark reaches are at infinite distance, hence every
connected component receives a landmark as long as `l` permits. There are fewer than `l` landmarks
if the mesh has fewer vertices, or if all of its vertices are at distance 0 of those chosen.

\tparam GeodesicDistances a model of `GeodesicDistances_3`
\tparam VertexOutputIterator a model of `OutputIterator` that takes vertex descriptors

\param geodesics the distances to sample with.
\param l the number of landmarks.
\param first the first landmark, see `extremal_point()`.
\param out receives the landmarks in the order of their choice.

\pre `l >= 1`

<em>Complexity:</em> one distance field per landmark.

\sa `front_landmarks()`
\sa `Landmark_mds_target_builder_3`
*/
template <class GeodesicDistances, class VertexOutputIterator = Emptyset_iterator>
Landmark_fields_3
farthest_point_landmarks(const GeodesicDistances& geodesics, const std::size_t l,
                         const typename GeodesicDistances::vertex_descriptor first,
                         VertexOutputIterator out = VertexOutputIterator())
{
  CGAL_precondition(l >= 1);
  const auto vertex_of_row = internal::vertex_descriptors(geodesics.triangle_mesh());
  const Eigen::Index n = static_cast<Eigen::Index>(vertex_of_row.size());
  const Eigen::Index columns = static_cast<Eigen::Index>((std::min)(l, vertex_of_row.size()));

  Landmark_fields_3 result;
  result.distances.resize(n, columns);
  Eigen::VectorXd nearest;
  Eigen::Index next = static_cast<Eigen::Index>(geodesics.index(first));
  for(Eigen::Index j = 0; j < columns; ++j)
  {
    const auto landmark = vertex_of_row[next];
    *out++ = landmark;
    result.landmarks.push_back(static_cast<std::size_t>(next));
    result.distances.col(j) = geodesics.distances(landmark);
    nearest = j == 0 ? Eigen::VectorXd(result.distances.col(j))
                     : Eigen::VectorXd(nearest.cwiseMin(result.distances.col(j)));
    result.covering_radius = nearest.maxCoeff(&next);
    if(result.covering_radius == 0)
      break;
  }
  result.distances.conservativeResize(n, static_cast<Eigen::Index>(result.landmarks.size()));
  return result;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_FARTHEST_POINT_LANDMARKS_H
