// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_3_embedder.h"
#include "mesh_3_complex.h"

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/mesh_3_body.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Embedded_body_3 mesh_3_body_of_clean_surface(Point_matrix points,
                                             const std::vector<Index_triangle>& triangles,
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
} // namespace Canonical_pose_3
} // namespace CGAL
