// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MAKE_TRIANGLE_MESH_H
#define CGAL_CANONICAL_POSE_3_MAKE_TRIANGLE_MESH_H

#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief creates a mesh from points and triangles, such as those of a `Repaired_surface_3`. Vertices
and faces are in the given order.

\tparam TriangleMesh a model of `MutableFaceGraph` with an internal point property map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.
\param np `geom_traits`, as for `CGAL::canonical_pose_3()`

\throws std::invalid_argument if a triangle has an invalid row, or the triangles are not an oriented
       2-manifold; the message states the index of the triangle.

<em>Complexity:</em> linear.
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
TriangleMesh make_triangle_mesh(const Point_matrix& points,
                                const std::vector<std::array<std::size_t, 3>>& triangles,
                                const NamedParameters& np = parameters::default_values())
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Point = typename boost::property_traits<
    typename boost::property_map<TriangleMesh, vertex_point_t>::type>::value_type;
  const auto traits = internal::traits_of_parameters<Point>(np);
  TriangleMesh mesh;
  std::vector<typename Graph_traits::vertex_descriptor> descriptors;
  for(Eigen::Index i = 0; i < points.rows(); ++i)
  {
    descriptors.push_back(add_vertex(mesh));
    put(vertex_point, mesh, descriptors.back(), internal::from_row(traits, points.row(i)));
  }
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    std::array<typename Graph_traits::vertex_descriptor, 3> corners;
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(triangles[f][k] >= descriptors.size())
        throw std::invalid_argument("triangle " + std::to_string(f) + " names vertex "
                                    + std::to_string(triangles[f][k]) + ", but there are "
                                    + std::to_string(descriptors.size()));
      corners[k] = descriptors[triangles[f][k]];
    }
    if(!Euler::can_add_face(corners, mesh)
       || Euler::add_face(corners, mesh) == Graph_traits::null_face())
      throw std::invalid_argument(
        "triangle " + std::to_string(f)
        + " does not fit the others: they are not an oriented 2-manifold there");
  }
  return mesh;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MAKE_TRIANGLE_MESH_H
