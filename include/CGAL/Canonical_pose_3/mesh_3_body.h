// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_MESH_3_BODY_H
#define CGAL_CANONICAL_POSE_3_MESH_3_BODY_H

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

constexpr double MESH_3_CELL_SIZE = 1. / 60;

// Precondition: the surface is clean.
Embedded_body_3 mesh_3_body_of_clean_surface(Point_matrix points,
                                             const std::vector<Index_triangle>& triangles,
                                             double length_scale,
                                             double cell_size = MESH_3_CELL_SIZE);

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief fills a clean closed surface with tetrahedra of nearly equal size by \cgal's Mesh_3, and
embeds the surface in them.

The number of cells does not depend on the number of faces, and the boundary of the cells is not the
surface but close to it. A vertex of the surface is a combination of the vertices of the cell that
contains it; if it is outside of all of them, of a cell nearby, of whose points it is an affine
combination with small coefficients. Nothing is random: the same surface gives the same body.

`canonical_pose_3()` offers this body only to programs that link the target `Canonical_pose_3::mesh_3`:
without `Canonical_pose_3::compiled` Mesh_3 takes long to compile.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.
\param length_scale \f$ L \f$, the length that `cell_size` refers to, in the unit of the points;
       usually the largest geodesic distance.
\param cell_size bound on the radius of the spheres around the cells, and on those around the faces
       of their boundary, as a fraction of \f$ L \f$. The boundary is within a tenth of it.

\throws std::invalid_argument if `diagnose()` finds a defect, the message names it and an element;
        also if the cells would be smaller than a thousandth of the surface.
\throws std::runtime_error if the surface is too thin for cells of this size: a part of it is lost,
        or all of it.

<em>Complexity:</em> that of `diagnose()` and of Mesh_3, close to linear in the number of cells (1 s
for 26 000 vertices and cells of \f$ L/60 \f$).

\sa `Embedded_body_3`
\sa `tetgen_body()`
*/
inline Embedded_body_3 mesh_3_body(const Point_matrix& points,
                                   const std::vector<std::array<std::size_t, 3>>& triangles,
                                   const double length_scale,
                                   const double cell_size = internal::MESH_3_CELL_SIZE)
{
  const Diagnosis_3 diagnosis = diagnose(points, triangles);
  if(!diagnosis.is_clean())
    throw std::invalid_argument(diagnosis.first_defect);
  return internal::mesh_3_body_of_clean_surface(points, triangles, length_scale, cell_size);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief fills a triangle mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and points
       of a kernel as values
*/
template <class TriangleMesh, class VertexPointMap>
Embedded_body_3 mesh_3_body(const TriangleMesh& tmesh, VertexPointMap vertex_point_map,
                            const double length_scale,
                            const double cell_size = internal::MESH_3_CELL_SIZE)
{
  return mesh_3_body(point_matrix(tmesh, vertex_point_map), internal::index_triangles(tmesh),
                     length_scale, cell_size);
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/body/mesh_3_body_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_MESH_3_BODY_H
