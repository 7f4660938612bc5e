// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_GEODESIC_DISTANCES_H
#define CGAL_CANONICAL_POSE_3_GEODESIC_DISTANCES_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/// \ingroup PkgCanonicalPose3Ref
/// computes geodesic distances on an oriented 2-manifold, possibly with boundary and several components. The
/// arguments are its points, its triangles as triples of rows, and the rows of the sources. Corners of
/// faces without area are moved by about 1e-9 of the size before, so that each face has an area. Returns
/// one row per point and one column per source.
using Distances_function = std::function<Eigen::MatrixXd(
  const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
  const std::vector<std::size_t>& sources)>;

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes geodesic distances on a polygon soup, which is repaired as in `canonical_pose_3()`.

Heat distances are not accurate where triangles are large against the shape: on such a component,
those of `Wavefront_geodesics_3` are returned instead. Where the surface is not manifold, it falls into
sheets; paths enter another sheet at the common vertices, and at the middles of long edges, which are
halved several times, so that distances over an edge in common to more than two faces are too large by
a small amount. They do so at 128 copies of vertices at most; if there are more, paths through the others
continue along edges, and are longer.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param sources rows of `points`.
\param options `geodesics`, `solver` and `number_of_threads` are used.
\param function if set, computes the distances instead.

\returns an \f$ n \times s \f$ matrix: one row per point, one column per source; infinite if there
       is no path, for instance to an isolated point.

\throws std::invalid_argument if a source is not a valid row or an isolated point; see also
       `repair_surface()`.

\sa `Heat_geodesics_3`
*/
Eigen::MatrixXd geodesic_distances(const Point_matrix& points, const Face_list& polygons,
                                   const std::vector<std::size_t>& sources,
                                   const Options& options = Options(),
                                   const Distances_function& function = Distances_function());

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_GEODESIC_DISTANCES_H
