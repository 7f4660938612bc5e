// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TETGEN_BODY_H
#define CGAL_CANONICAL_POSE_3_TETGEN_BODY_H

#ifndef CGAL_CANONICAL_POSE_3_USE_TETGEN
#error "tetgen_body.h needs TetGen: link the CMake target Canonical_pose_3::tetgen"
#endif

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Precondition: the surface is clean (TetGen may terminate the process otherwise).
Conforming_body_3 tetgen_body_of_clean_surface(const Point_matrix& points,
                                               const std::vector<Index_triangle>& triangles);

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief fills a clean closed surface with tetrahedra, using TetGen
\cgalCite{cgal:canonical-s-tdbqtmg-15}, without new vertices on the surface.

The surface is examined first, since TetGen terminates the process on many defects. TetGen is
licensed under the AGPL, which applies to programs that include this header (target
`Canonical_pose_3::tetgen`).

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`; instead of them, a
       point map.

\throws std::invalid_argument if `diagnose()` finds a defect; the message states the defect and an
       element.
\throws std::runtime_error if TetGen fails.

<em>Complexity:</em> that of `diagnose()` and of TetGen, close to linear in practice (0.3 s for 26
000 vertices).

\sa `Conforming_body_3`
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Conforming_body_3 tetgen_body(const TriangleMesh& tmesh,
                              const NamedParameters& np = parameters::default_values())
{
  const Point_matrix points = internal::points_of_parameters(tmesh, np);
  const auto triangles = internal::index_triangles(tmesh);
  const Diagnosis_3 diagnosis = diagnose(points, triangles);
  if(!diagnosis.is_clean())
    throw std::invalid_argument(diagnosis.first_defect);
  return internal::tetgen_body_of_clean_surface(points, triangles);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TETGEN_BODY_H
