// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H
#define CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H

#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Lattice_body_data.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an elastic body for any oriented surface, including surfaces with self-intersections or
holes: the cubes of a regular lattice that intersect the solid, each subdivided into six tetrahedra.

If several parts of the solid pass through the same cube (two fingers, or limbs that overlap), each
has a copy of the cube with its own nodes \cgalCite{cgal:canonical-mbf-vna-04}, so that the target
can separate the parts. The solid is explored along *chords*, which run from surface samples against
the normal to the exit from the solid. Parts are distinguished by geodesic distances: two pieces in
a cube belong to the same part if their distance on the surface is similar to that through the
solid.

A cube that intersects the surface is weighted by its filled share. A vertex of the surface is
embedded in the tetrahedron that contains it, by barycentric coordinates. The lattice is aligned
with the principal axes of the surface, so it follows rigid motions and scaling. The size of the
body does not depend on the resolution of the surface.

\cgalModels `ElasticBody_3`

\sa `canonical_pose_3()`
\sa `Conforming_body_3`
*/
class Lattice_body_3
{
public:
  /*!
  constructs the body.

  \param points \f$ n \times 3 \f$, vertices of the surface.
  \param triangles triples of rows of `points`, oriented such that normals point outward.
  \param distances \f$ n \times l \f$, geodesic distances to landmarks, see
         `farthest_point_landmarks()`. The largest is the length \f$ L \f$.
  \param spacing edge length of the cubes as a fraction of \f$ L \f$; if 0, it is chosen based on
         the lengths of the chords, such that thin limbs are about two cubes wide, within bounds.
  \param caps triangles of vertices that close the holes of the surface.

  \pre `distances.rows() == points.rows()`, and there is at least one column.

  \throws std::invalid_argument if a triangle has an invalid row, the spacing is neither 0 nor from
         \f$ 10^{-6} \f$ to 1, or so small that there would be tens of millions of cubes, a vertex
         is isolated, the surface has no area, or a distance is not finite (for instance for several components).

  <em>Complexity:</em> linear in the numbers of triangles, cubes and cubes along the chords.
  */
  Lattice_body_3(const Point_matrix& points, std::vector<std::array<std::size_t, 3>> triangles,
                 const Eigen::MatrixXd& distances, double spacing = 0,
                 const std::vector<std::array<std::size_t, 3>>& caps = {});

  /// constructs the body of a triangle mesh.
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and
  ///         points of a kernel as values
  template <class TriangleMesh, class VertexPointMap>
  Lattice_body_3(const TriangleMesh& tmesh, VertexPointMap vertex_point_map,
                 const Eigen::MatrixXd& distances, const double spacing = 0)
    : Lattice_body_3(point_matrix(tmesh, vertex_point_map), internal::index_triangles(tmesh),
                     distances, spacing)
  {}

  /// constructs the body of a triangle mesh, with named parameters: `vertex_point_map` and
  /// `geom_traits`, as for `CGAL::canonical_pose_3()`.
  template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters,
            std::enable_if_t<internal::Is_named_parameters<NamedParameters>::value, int> = 0>
  Lattice_body_3(const TriangleMesh& tmesh, const Eigen::MatrixXd& distances,
                 const double spacing = 0, const NamedParameters& np = parameters::default_values())
    : Lattice_body_3(internal::points_of_parameters(tmesh, np), internal::index_triangles(tmesh),
                     distances, spacing)
  {}

  /// the same with the default spacing.
  template <class TriangleMesh, class T, class Tag, class Base>
  Lattice_body_3(const TriangleMesh& tmesh, const Eigen::MatrixXd& distances,
                 const Named_function_parameters<T, Tag, Base>& np)
    : Lattice_body_3(tmesh, distances, 0, np)
  {}

  /// \cond SKIP_IN_MANUAL
  Lattice_body_3(const Point_matrix& points, std::vector<std::array<std::size_t, 3>> triangles,
                 internal::Geodesic_bounds bounds, double spacing,
                 const std::vector<std::array<std::size_t, 3>>& caps, double share_of_cells = 1);
  /// \endcond

  /// returns the \f$ N \times 3 \f$ nodes, in the unit of the surface.
  const Point_matrix& points() const { return m_data.points; }

  /// returns the cells, four rows of `points()` each; each cube has six consecutive cells.
  const std::vector<std::array<int, 4>>& cells() const { return m_data.cells; }

  /// returns the share of each cell in the volume, counting only the filled part of cubes at the
  /// surface; the sum is 1.
  const Eigen::VectorXd& cell_weights() const { return m_data.cell_weights; }

  /// returns the filled volume.
  double volume() const { return m_data.volume; }

  /// returns the \f$ n \times N \f$ matrix \f$ B \f$ with at most four entries per row.
  const Eigen::SparseMatrix<double>& embedding() const { return m_data.embedding; }

  /// returns the edge length of the cubes as a fraction of \f$ L \f$.
  double spacing() const { return m_data.spacing; }

private:
  internal::Lattice_body_data m_data;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H
