// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FARTHEST_POINT_LANDMARKS_H
#define CGAL_CANONICAL_POSE_3_FARTHEST_POINT_LANDMARKS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>
#include <CGAL/iterator.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the point farthest from the area-weighted centroid of a triangle soup.

The choice is invariant under rigid motions and scaling and, except for ties, independent of the
order of the points; it is the default first landmark. Among points at equal distance, the first one
is returned.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.

\pre `points` has at least one row.

\throws std::invalid_argument if a triangle has an invalid row.

<em>Complexity:</em> linear.

\sa `farthest_point_landmarks()`
*/
inline std::size_t extremal_point(Point_matrix points,
                                  const std::vector<std::array<std::size_t, 3>>& triangles)
{
  CGAL_precondition(points.rows() > 0);
  internal::check_elements(triangles, static_cast<std::size_t>(points.rows()));
  internal::normalize(points);
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

\brief returns the vertex of a triangle mesh farthest from the area-weighted centroid, which is the
first landmark of the one call.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`; instead of them, a
       point map.

\throws std::invalid_argument if a coordinate is not finite or a face is not a triangle.
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor
extremal_vertex(const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  const std::size_t row
    = extremal_point(internal::points_of_parameters(tmesh, np), internal::index_triangles(tmesh));
  return *std::next(vertices(tmesh).begin(), static_cast<std::ptrdiff_t>(row));
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief selects landmarks by farthest point sampling \cgalCite{cgal:canonical-elpz-fpsi-97} and
returns them with their distance fields.

Starting with `first`, the vertex farthest from all landmarks so far is added until there are `l`
landmarks. The result is deterministic; among vertices at equal distance, the first one in the order
of `vertices(tmesh)` is chosen. Vertices that are not connected to a landmark are at infinite
distance, so every connected component receives a landmark if `l` is large enough. There are fewer
than `l` landmarks if the mesh has fewer vertices, or if all remaining vertices are at distance 0
from the landmarks.

\tparam GeodesicDistances a model of `GeodesicDistances_3`
\tparam VertexOutputIterator a model of `OutputIterator` that accepts vertex descriptors

\param geodesics the distances used for sampling.
\param l the number of landmarks.
\param first the first landmark, see `extremal_point()`.
\param out receives the landmarks in the order in which they are chosen.

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
  CGAL_precondition(next >= 0 && next < n);
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

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_FARTHEST_POINT_LANDMARKS_H
