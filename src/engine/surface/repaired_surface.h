// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_REPAIRED_SURFACE_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_REPAIRED_SURFACE_H

#include "Component_orienter.h"
#include "Manifold_builder.h"
#include "Soup_topology.h"

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// `points`: the given ones. `topology`: that of the triangles of its soup.
inline Repaired_surface_3 repaired_surface(const Point_matrix& points,
                                           const Soup_topology& topology)
{
  if(!topology.soup.has_faces())
    throw std::invalid_argument(Checked_soup::NO_FACE);
  Repaired_surface_3 result;
  Manifold_builder builder(topology);
  builder.run(result);
  result.points = rows_at(points, result.origins);
  Component_orienter(rows_at(topology.soup.points(), result.origins), builder.twins(), result)
    .run();
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_REPAIRED_SURFACE_H
