// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CUT_CONTACTS_H
#define CGAL_CANONICAL_POSE_3_CUT_CONTACTS_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief cuts false contacts of a surface: handles that arise where parts touch and were merged, such as
a hand with a knee.

A contact is a short closed curve around a narrow neck whose two sides are far from each other on the
surface if the neck is cut. With \f$ s \f$ the square root of the area, the surface is cut along a
curve of edges if it is not longer than \f$ s/4 \f$, the surface remains connected, and the distance
between both sides becomes at least \f$ 0.6\,s \f$. Candidates are the shortest closed curves through
concave edges that cannot be contracted, computed by CGAL's package Surface Mesh Topology; concave
edges count as shorter than they are, since necks of contacts have creases. True handles that fulfill
these conditions, such as a thin ring, are also cut.

In a pose of the input, a vertex of the curve is halfway between its two copies.

\param surface a connected surface.

\returns the surface; the vertices of each curve exist twice afterwards, the copies are the last rows of
         `points`. Unchanged if there is no contact, or its boundary loops cannot be closed by its caps.

<em>Complexity:</em> \f$ O(n \log n) \f$ per candidate and contact, at most 32 candidates per contact.
There are none, and it takes \f$ O(n) \f$, if the surface has no handle.

\sa `Method_options::contacts`
*/
Surface_component_3 cut_contacts(const Surface_component_3& surface);

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CUT_CONTACTS_H
