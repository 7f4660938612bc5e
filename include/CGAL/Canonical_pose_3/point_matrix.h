// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_POINT_MATRIX_H
#define CGAL_CANONICAL_POSE_3_POINT_MATRIX_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief A matrix of points: row `i` holds the three Cartesian coordinates of point `i`, in the unit
of the input. For a mesh, row `i` corresponds to the `i`-th vertex of the range `vertices(tmesh)`;
removed vertices have no row.
*/
using Point_matrix = Eigen::Matrix<double, Eigen::Dynamic, 3>;

namespace internal {

// the kernel of the value type of a property map
template <class VertexPointMap>
using Kernel_of_point_map =
  typename Kernel_traits<typename boost::property_traits<VertexPointMap>::value_type>::Kernel;

// the same, instantiated only if required: user-defined point types have no kernel
template <class VertexPointMap>
struct Lazy_kernel_of_point_map
{
  using type = Kernel_of_point_map<VertexPointMap>;
};

template <class Traits>
Eigen::Vector3d to_row(const Traits& traits, const typename Traits::Point_3& point)
{
  return Eigen::Vector3d(CGAL::to_double(traits.compute_x_3_object()(point)),
                         CGAL::to_double(traits.compute_y_3_object()(point)),
                         CGAL::to_double(traits.compute_z_3_object()(point)));
}

// `row`: any Eigen vector expression of three entries, row or column
template <class Traits, class Row>
typename Traits::Point_3 from_row(const Traits& traits, const Row& row)
{
  using FT = typename Traits::FT;
  return traits.construct_point_3_object()(static_cast<FT>(row[0]), static_cast<FT>(row[1]),
                                           static_cast<FT>(row[2]));
}

// all vertices, in the order of the rows
template <class VertexListGraph>
std::vector<typename boost::graph_traits<VertexListGraph>::vertex_descriptor>
vertex_descriptors(const VertexListGraph& graph)
{
  using Vertex = typename boost::graph_traits<VertexListGraph>::vertex_descriptor;
  const auto range = vertices(graph);
  return std::vector<Vertex>(range.begin(),
                             range.end()); // no braces: iterators may convert to vertices
}

inline void check_finite(const Point_matrix& points)
{
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    if(!points.row(i).allFinite())
      throw std::invalid_argument("vertex " + std::to_string(i)
                                  + " has a coordinate that is not finite");
}

// Multiplies numbers by 2^exponent, in two steps, since the factor may be out of range.
template <class Matrix>
void multiply_by_power_of_two(Matrix& numbers, const int exponent)
{
  numbers *= std::ldexp(1., exponent / 2);
  numbers *= std::ldexp(1., exponent - exponent / 2);
}

// Multiplies the points by a power of two, so that the largest coordinate lies in [1,2), and
// returns the exponent that undoes it. Squares and products of coordinates cannot overflow
// afterwards, and point sets that differ by a power of two become bitwise equal.
inline int normalize(Point_matrix& points)
{
  const double largest = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0.;
  if(!(largest > 0))
    return 0;
  const int exponent = std::ilogb(largest);
  multiply_by_power_of_two(points, -exponent);
  return exponent;
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief reads the points of all vertices of `tmesh` from a property map.

\tparam TriangleMesh a model of `VertexListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with the vertex descriptor as key type and
        `Traits::Point_3` as value type
\tparam Traits a model of `CanonicalPoseTraits_3`

\param tmesh the mesh; its range of vertices determines the order of the rows
\param vertex_point_map the point of each vertex
\param traits the traits that read the coordinates of a point

\returns a matrix with one row per vertex
\throws std::invalid_argument stating the index of the first vertex with a non-finite coordinate

\par Complexity Linear in the number of vertices.
*/
template <class TriangleMesh, class VertexPointMap, class Traits>
Point_matrix point_matrix(const TriangleMesh& tmesh, VertexPointMap vertex_point_map,
                          const Traits& traits)
{
  const auto descriptors = internal::vertex_descriptors(tmesh);
  Point_matrix points(static_cast<Eigen::Index>(descriptors.size()), 3);
  Eigen::Index row = 0;
  for(const auto& v : descriptors)
    points.row(row++) = internal::to_row(traits, get(vertex_point_map, v)).transpose();
  internal::check_finite(points);
  return points;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief reads the points of all vertices of `tmesh` from a property map, with the kernel of the
points.

Equivalent to the overload above with a default-constructed kernel of the points as traits.
*/
template <class TriangleMesh, class VertexPointMap>
Point_matrix point_matrix(const TriangleMesh& tmesh, VertexPointMap vertex_point_map)
{
  return point_matrix(tmesh, vertex_point_map, internal::Kernel_of_point_map<VertexPointMap>());
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief reads the points of all vertices of `tmesh` from its internal property map `vertex_point`.

Equivalent to the overload above with `get(vertex_point, tmesh)` as property map.
*/
template <class TriangleMesh>
Point_matrix point_matrix(const TriangleMesh& tmesh)
{
  return point_matrix(tmesh, get(vertex_point, tmesh));
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief writes one point per vertex of `tmesh` to a property map.

\tparam TriangleMesh a model of `VertexListGraph`
\tparam VertexPointMap a model of `WritablePropertyMap` with the vertex descriptor as key type and
        `Traits::Point_3` as value type
\tparam Traits a model of `CanonicalPoseTraits_3`

\param points one row per vertex of `tmesh`, in the order of `vertices(tmesh)`
\param tmesh the mesh, which is not modified unless `vertex_point_map` is its internal map
\param vertex_point_map receives the points
\param traits the traits that construct a point from its coordinates

\pre `points` has as many rows as `tmesh` has vertices (not counting removed ones).

\par Complexity Linear in the number of vertices.
*/
template <class TriangleMesh, class VertexPointMap, class Traits>
void put_points(const Point_matrix& points, const TriangleMesh& tmesh,
                VertexPointMap vertex_point_map, const Traits& traits)
{
  const auto descriptors = internal::vertex_descriptors(tmesh);
  CGAL_precondition(points.rows() == static_cast<Eigen::Index>(descriptors.size()));
  Eigen::Index row = 0;
  for(const auto& v : descriptors)
    put(vertex_point_map, v, internal::from_row(traits, points.row(row++)));
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_POINT_MATRIX_H
