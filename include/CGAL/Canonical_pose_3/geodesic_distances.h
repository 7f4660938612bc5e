// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_GEODESIC_DISTANCES_H
#define CGAL_CANONICAL_POSE_3_GEODESIC_DISTANCES_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/// \ingroup PkgCanonicalPose3Ref
/// computes distances on an oriented 2-manifold, possibly with boundary and several components. The
/// arguments are its points, its triangles as triples of rows, and the rows of the sources. Returns
/// one row per point and one column per source.
using Distances_function = std::function<Eigen::MatrixXd(
  const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
  const std::vector<std::size_t>& sources)>;

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes distances on a polygon soup, which is repaired as in `canonical_pose_3()`.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param sources rows of `points`.
\param options `geodesics`, `solver` and `number_of_threads` are used.
\param function if set, computes the distances instead.

\returns an \f$ n \times s \f$ matrix: one row per point, one column per source; infinite if there
       is no path. For a vertex that was split, the distance of its first copy is returned.

\throws std::invalid_argument if a source is not a valid row or a point is isolated; see also
       `repair_surface()`.

\sa `Heat_geodesics_3`
*/
Eigen::MatrixXd geodesic_distances(const Point_matrix& points,
                                   const std::vector<std::vector<std::size_t>>& polygons,
                                   const std::vector<std::size_t>& sources,
                                   const Options& options = Options(),
                                   const Distances_function& function = Distances_function());

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/pipeline/geodesic_distances_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_GEODESIC_DISTANCES_H
