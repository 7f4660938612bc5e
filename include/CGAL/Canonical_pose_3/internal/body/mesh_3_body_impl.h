// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_BODY_MESH_3_BODY_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_BODY_MESH_3_BODY_IMPL_H

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/internal/body/Mesh_3_embedder.h>
#include <CGAL/Canonical_pose_3/internal/body/mesh_3_complex.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/mesh_3_body.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

CGAL_CANONICAL_POSE_3_INLINE Embedded_body_3
mesh_3_body_of_clean_surface(Point_matrix points, const std::vector<Index_triangle>& triangles,
                             const double length_scale, const double cell_size)
{
  require_positive("length_scale", length_scale);
  require_positive("cell_size", cell_size);
  const int exponent = normalize(points); // so that squares of lengths neither vanish nor overflow
  const double size = cell_size * std::ldexp(length_scale, -exponent);
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  if(!(size >= extent / 1000) || !std::isfinite(size))
    throw std::invalid_argument("the cells would be smaller than a thousandth of the surface, or "
                                "their size is not finite");
  const Mesh_3_complex complex = mesh_3_complex(points, triangles, size);
  return Mesh_3_embedder(complex).body(points, exponent);
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_BODY_MESH_3_BODY_IMPL_H
