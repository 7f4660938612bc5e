// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_COARSE_SURFACE_3_H
#define CGAL_CANONICAL_POSE_3_COARSE_SURFACE_3_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Vertex_combination_3.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a simplified copy of a surface, with a map between both.

Its vertices are vertices of the surface, usually some thousand of them at even distances. Geodesic
distances are nearly the same on both surfaces, but take much less time on the coarse one. It can
follow any motion of the surface, since its points are the points of `vertices`.

\sa `coarse_surface()`
*/
struct Coarse_surface_3
{
  /// the coarse surface. Each of its triangles has replaced a triangle of the surface, and belongs
  /// to the same face; its `origins` are those of `vertices`. There are no caps.
  Surface_component_3 surface;

  /// the vertex of the surface for each vertex of the coarse one, in increasing order.
  std::vector<std::size_t> vertices;

  /// all other vertices of the surface: each is a combination of `vertices` and of vertices of
  /// earlier combinations.
  std::vector<Vertex_combination_3> combinations;

  /// returns the coarse surface in a pose of the surface, given by one row per vertex of it.
  Surface_component_3 posed(const Point_matrix& pose) const
  {
    CGAL_precondition(pose.rows() == static_cast<Eigen::Index>(number_of_surface_vertices()));
    Surface_component_3 result = surface;
    result.points = internal::rows_at(pose, vertices);
    return result;
  }

  /// returns the number of vertices of the surface.
  std::size_t number_of_surface_vertices() const { return vertices.size() + combinations.size(); }

  /*!
  interpolates values on the coarse surface linearly. The values at `vertices` are reproduced; all
  others are between the smallest and the largest one.

  \tparam Matrix a matrix type of Eigen with a dynamic number of rows; storage by rows is faster.

  \param values one row per vertex of the coarse surface.

  \returns one row per vertex of the surface.

  \pre `values` has as many rows as the coarse surface has vertices.

  <em>Complexity:</em> linear.
  */
  template <class Matrix>
  Matrix interpolated(const Matrix& values) const
  {
    CGAL_precondition(values.rows() == static_cast<Eigen::Index>(vertices.size()));
    Matrix result(static_cast<Eigen::Index>(number_of_surface_vertices()), values.cols());
    const auto row = [&](const std::size_t v) { return result.row(static_cast<Eigen::Index>(v)); };
    for(std::size_t i = 0; i < vertices.size(); ++i)
      row(vertices[i]) = values.row(static_cast<Eigen::Index>(i));
    using Scalar = typename Matrix::Scalar;
    for(const auto& [vertex, others, weights] : combinations)
      row(vertex).noalias() = static_cast<Scalar>(weights[0]) * row(others[0])
                              + static_cast<Scalar>(weights[1]) * row(others[1])
                              + static_cast<Scalar>(weights[2]) * row(others[2]);
    return result;
  }
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief simplifies a surface to about `number_of_vertices` vertices.

Edges are contracted to one of their ends, the shortest ones first, unless this would change the
topology, fold the surface over, or cut off a tip. So the vertices of the result are spread evenly,
except for thin parts, where they are denser. If the surface has at most `number_of_vertices`
vertices, the result is a copy of it.

\param surface the surface, for example a component of `prepare_surface()`.
\param number_of_vertices the approximate number of vertices of the result; surfaces of a
       complicated topology may keep more.
\param kept vertices of the surface that must be vertices of the result.

\pre The surface is an oriented 2-manifold, and all points are finite.

\throws std::invalid_argument if one of `kept` is not a vertex of the surface.

<em>Complexity:</em> \f$ O(n \log n) \f$.
*/
Coarse_surface_3 coarse_surface(const Surface_component_3& surface, std::size_t number_of_vertices,
                                const std::vector<std::size_t>& kept = {});

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_COARSE_SURFACE_3_H
