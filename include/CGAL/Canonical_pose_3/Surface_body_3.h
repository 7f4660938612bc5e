// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SURFACE_BODY_3_H
#define CGAL_CANONICAL_POSE_3_SURFACE_BODY_3_H

#include <CGAL/Canonical_pose_3/Elastic_body_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the body of a surface.

\sa `surface_body()`
*/
struct Surface_body_3
{
  /// see `Registration_summary::Body::kind`.
  std::string kind;

  /// the body.
  Elastic_body_3 body;

  /// \f$ L \f$, the largest distance on the surface; the detail length is relative to it.
  double length_scale = 0;

  /// the surface vertex of the body for each vertex of the surface.
  std::vector<std::size_t> surface_vertices;

  /// positive factors of the cell weights, or empty.
  Eigen::VectorXd stiffness;

  /// warnings of one line each, see `Registration_summary::warnings`.
  std::vector<std::string> warnings;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SURFACE_BODY_3_H
