// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_DIAGNOSE_H
#define CGAL_CANONICAL_POSE_3_DIAGNOSE_H

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
/*!
\ingroup PkgCanonicalPose3Ref

\brief examines a polygon soup, and searches self-intersections.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.

If coordinates are not finite or polygons have invalid rows, all of these are defects, and nothing else is
examined.

<em>Complexity:</em> \f$ O(n \log n) \f$, plus the search for intersections. The search ends when
`Diagnosis_3::MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS` pairs are found, or when the number of
overlapping bounding boxes exceeds both 200 per face and ten million.

\sa `repair_surface()`
*/
Diagnosis_3 diagnose(const Point_matrix& points, const Face_list& polygons);

/*!
\ingroup PkgCanonicalPose3Ref

\brief examines the boundary of a tetrahedral complex: the faces of exactly one cell, oriented
outward, in the order of the cells.

\param points \f$ n \times 3 \f$, positions. Those that are not on the boundary are not counted.
\param cells quadruples of rows of `points`.

\throws std::invalid_argument if a cell names a vertex twice, or a face belongs to more than two cells.

\sa `extract_boundary()`
*/
Diagnosis_3 diagnose(const Point_matrix& points,
                     const std::vector<std::array<std::size_t, 4>>& cells);

/*!
\ingroup PkgCanonicalPose3Ref

\brief examines a polygon mesh.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`; instead of them, a
       point map.
*/
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!std::is_same<PolygonMesh, Point_matrix>::value, int> = 0>
Diagnosis_3 diagnose(const PolygonMesh& mesh,
                     const NamedParameters& np = parameters::default_values())
{
  return diagnose(internal::points_of_parameters(mesh, np), internal::index_polygons(mesh));
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DIAGNOSE_H
