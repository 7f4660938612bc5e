// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TRANSFER_ATTRIBUTES_H
#define CGAL_CANONICAL_POSE_3_TRANSFER_ATTRIBUTES_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Surface_match_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns for each face of the first surface of a match a face of the second one: that with the vertices near which its
corners are, weighted by their barycentric coordinates. So labels, materials, and other values of faces are transferred.
For a surface that is matched with itself vertex by vertex, it is the face itself.

\param match the result of `match_surfaces()`.
\param faces the faces of the first surface.
\param other_points positions of the second surface, one row per vertex. Vertices at the same position count as one.
\param other_faces the faces of the second surface.

\pre Faces have vertices, which are those of the surfaces of the match.
*/
std::vector<std::size_t> matched_faces(const Surface_match_3& match, const Face_list& faces,
                                       const Point_matrix& other_points,
                                       const Face_list& other_faces);

/*!
\ingroup PkgCanonicalPose3Ref

\brief transfers texture coordinates from the second surface of a match to the first one.

Where a face of the first surface lies across a seam, its coordinates are those of `matched_faces()`, extrapolated: no
face shows what lies between the charts of an atlas. Where its corners are far from each other on the second surface, all have
the same coordinates.

\param match the result of `match_surfaces()`.
\param faces the faces of the first surface.
\param other_points positions of the second surface, one row per vertex.
\param other_faces the faces of the second surface.
\param other_coordinates the texture coordinates of the corners of all `other_faces`, in their order.

\returns those of the corners of all `faces`.

\pre Faces and coordinates belong to the surfaces of the match.

\sa `Surface_match_3::interpolated()`, for values of vertices
*/
std::vector<std::array<float, 2>>
transferred_texture_coordinates(const Surface_match_3& match, const Face_list& faces,
                                const Point_matrix& other_points, const Face_list& other_faces,
                                const std::vector<std::array<float, 2>>& other_coordinates);

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TRANSFER_ATTRIBUTES_H
