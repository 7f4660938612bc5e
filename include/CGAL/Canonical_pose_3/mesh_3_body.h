// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MESH_3_BODY_H
#define CGAL_CANONICAL_POSE_3_MESH_3_BODY_H

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline constexpr double MESH_3_CELL_SIZE = 1. / 60;

// Precondition: the surface is clean.
Embedded_body_3 mesh_3_body_of_clean_surface(Point_matrix points,
                                             const std::vector<Index_triangle>& triangles,
                                             double length_scale,
                                             double cell_size = MESH_3_CELL_SIZE);

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief fills a clean closed surface with tetrahedra of nearly equal size, using Mesh_3 of \cgal, and
embeds the surface in them.

The number of cells does not depend on the number of faces, and the boundary of the cells only
approximates the surface. A vertex of the surface is a combination of the vertices of the cell that
contains it; if it is outside of all cells, it is an affine combination with small coefficients of
the vertices of a nearby cell. The body is deterministic.

`canonical_pose_3()` provides this body only if the program links the target
`Canonical_pose_3::mesh_3`.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.
\param length_scale \f$ L \f$, the length to which `cell_size` is relative, in the unit of the
       points; usually the largest geodesic distance.
\param cell_size bound on the circumradii of the cells, and of the faces of their boundary, as a
       fraction of \f$ L \f$. The distance to the boundary is at most a tenth of it.

\throws std::invalid_argument if `diagnose()` finds a defect, stating the defect and an element;
       also if the length or the size is not positive and finite, or the cells would be smaller than a
       thousandth of the surface.
\throws std::runtime_error if the surface is too thin for cells of this size, so that all or part of
       it is lost.

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

/*!
\ingroup PkgCanonicalPose3Ref

\brief fills a triangle mesh, with named parameters.

\param tmesh the mesh.
\param length_scale as above.
\param cell_size as above.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`
*/
template <class TriangleMesh, class T, class Tag, class Base>
Embedded_body_3 mesh_3_body(const TriangleMesh& tmesh, const double length_scale,
                            const double cell_size,
                            const Named_function_parameters<T, Tag, Base>& np)
{
  return mesh_3_body(internal::points_of_parameters(tmesh, np), internal::index_triangles(tmesh),
                     length_scale, cell_size);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MESH_3_BODY_H
