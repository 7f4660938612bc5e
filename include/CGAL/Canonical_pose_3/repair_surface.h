// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_REPAIR_SURFACE_H
#define CGAL_CANONICAL_POSE_3_REPAIR_SURFACE_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline std::vector<std::size_t> first_copies(const Repaired_surface_3& surface)
{
  const std::size_t none = surface.origins.size();
  std::vector<std::size_t> first(surface.representatives.size(), none), result;
  for(std::size_t copy = none; copy-- > 0;)
    first[surface.origins[copy]] = copy;
  for(const std::size_t v : surface.representatives)
    result.push_back(first[v]);
  return result;
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief creates an oriented 2-manifold from any polygons, without moving or adding points.

Polygons are triangulated. Faces with fewer than three distinct vertices, and all but one of the
faces with the same vertices, are removed. Boundary vertices at the same position (as in an STL
file) are stitched; closed surfaces that touch remain separate. Adjacent faces are oriented
consistently; where this is impossible (a Moebius strip), the surface is cut. Vertices where several
fans of faces meet are split. At an edge with more than two faces, faces of the same patch
(connected by edges with two faces) become neighbors first, then those of patches without boundary,
then the others; so a fin on a closed surface becomes a separate component. Holes get caps, and
components are oriented outward; the orientation of flat sheets does not change. Faces without area
are kept.

A surface that needs no repair is returned unchanged.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.

\throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, or no
       face has an area; the message names the element.

<em>Complexity:</em> \f$ O(n \log n) \f$.

\sa `diagnose()`
*/
Repaired_surface_3 repair_surface(const Point_matrix& points, const Face_list& polygons);

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns one component of a surface, with its vertices and caps.

\param surface the surface.
\param component index of the component; components are sorted by decreasing area.

\throws std::invalid_argument if there is no such component.
*/
Repaired_surface_3 component_of_surface(const Repaired_surface_3& surface, std::size_t component);

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REPAIR_SURFACE_H
