// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H
#define CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H

#include <CGAL/Canonical_pose_3/internal/lattice/Lattice_body_data.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an elastic body for any oriented surface, one that intersects itself or has holes included:
the cubes of a regular lattice that the solid passes through, each cut into six tetrahedra.

Where several parts of the solid pass through the same cube (two fingers, or limbs that overlap),
each has a copy of the cube with nodes of its own \cgalCite{cgal:canonical-mbf-vna-04}, so that the
parts come apart when the target says so. The solid is followed from the surface along *chords*, the
ways from points of the surface against the normal to the exit from the solid; parts are told apart
by geodesic distances: two pieces in a cube are of the same part if they lie about as near to one
another on the surface as through the solid.

A cube that the surface passes through weighs as much as is filled of it. A vertex of the surface
is embedded in the tetrahedron that holds it, by barycentric coordinates. The lattice lies along the
principal axes of area, so that it follows rigid motions and scaling. The size of the body does not
depend on the resolution of the surface.

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
  \param triangles triples of rows of `points`, oriented so that the normals point outwards.
  \param distances \f$ n \times l \f$, geodesic distances to landmarks, see
         `farthest_point_landmarks()`. The largest is the length \f$ L \f$.
  \param spacing side of the cubes as a fraction of \f$ L \f$; 0: chosen from the lengths of the
         chords, so that thin limbs are about two cubes wide, within bounds.
  \param caps triangles over the vertices that close the holes of the surface.

  \pre `distances.rows() == points.rows()`, and there is a column.

  \throws std::invalid_argument if the spacing is negative or so small that there would be tens of
         millions of cubes, a vertex belongs to no triangle, the surface has no area, or a distance
         is not finite (several components, for instance).

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

  /// returns the \f$ N \times 3 \f$ nodes, in the unit of the surface.
  const Point_matrix& points() const { return m_data.points; }

  /// returns the cells, four rows of `points()` each; six in a row are those of a cube.
  const std::vector<std::array<int, 4>>& cells() const { return m_data.cells; }

  /// returns the share of each cell in the volume, of cubes on the surface the filled part; the sum
  /// is 1.
  const Eigen::VectorXd& cell_weights() const { return m_data.cell_weights; }

  /// returns the filled volume.
  double volume() const { return m_data.volume; }

  /// returns the \f$ n \times N \f$ matrix \f$ B \f$ with four entries per row at most.
  const Eigen::SparseMatrix<double>& embedding() const { return m_data.embedding; }

  /// returns the side of the cubes as a fraction of \f$ L \f$.
  double spacing() const { return m_data.spacing; }

private:
  internal::Lattice_body_data m_data;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/lattice/Lattice_body_3_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H
