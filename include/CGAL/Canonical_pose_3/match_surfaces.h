// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MATCH_SURFACES_H
#define CGAL_CANONICAL_POSE_3_MATCH_SURFACES_H

#include <CGAL/Canonical_pose_3/Match_options.h>
#include <CGAL/Canonical_pose_3/Matchable_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_match_3.h>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief finds for each vertex of a surface the point of another one that corresponds to it, such as the tip of the
left hand to the tip of the left hand.

Canonical poses of similar shapes are similar, and have the same handedness, so left and right are not confused. The
pose of the first surface is rotated toward that of the second one: its principal axes give four ways (or more, if
axes have similar lengths). Then points are compared by more and more eigenfunctions of the Laplacian, mapped by a functional
map (M. Ovsjanikov et al., "Functional maps", 2012; the refinement is that of S. Melzi et al., "ZoomOut", 2019), and by their
positions in the pose, which a smooth displacement brings closer; each coordinate counts in units of its residual. Of
rotations after which the poses are nearly as close, that is chosen whose match changes lengths of edges, functions and positions
the least. At last, the pose of the first surface is registered, as rigidly as possible, to the points of the second one that match,
and vertices are where they then are on the other pose, on the same side of thin parts.

The mirror symmetry of a shape is its match with its mirror image, that is, with its own points, one coordinate negated, and
reversed faces; the pose of this mirror image is not the mirror image of the pose.

\param surface the first surface.
\param other the second surface.
\param options the options.

\throws std::invalid_argument if a landmark is no vertex or contradicts another one, or an option is out of range.

<em>Complexity:</em> \f$ O(n \log n) \f$ for the vertices of both surfaces.
*/
Surface_match_3 match_surfaces(const Matchable_surface_3& surface, const Matchable_surface_3& other,
                               const Match_options& options = Match_options());

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MATCH_SURFACES_H
