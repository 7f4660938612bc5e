// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_MATCH_SURFACE_PROJECTION_H
#define CANONICAL_POSE_3_ENGINE_MATCH_SURFACE_PROJECTION_H

#include "Matchable_data.h"
#include "../support/Point_search.h"

#include <CGAL/Canonical_pose_3/Surface_match_3.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Finds points of a surface in a pose, which must outlive it.
class Surface_projection
{
public:
  using Location = Surface_match_3::Location;

  Surface_projection(const Matchable_data& shape, const Point_matrix& pose,
                     const Point_matrix& normals);

  // The nearest ones, on the same side of thin parts where normals of the positions are given.
  std::vector<Location> locations(const Point_matrix& positions,
                                  const Point_matrix& normals = Point_matrix(0, 3)) const;

private:
  Location location(const std::vector<std::size_t>& rows, const Eigen::Vector3d& position) const;

  const Matchable_data& m_shape;
  const Point_matrix &m_pose, &m_normals;
  const Point_search m_search;
  const Buckets<std::size_t> m_triangles; // at each row
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_SURFACE_PROJECTION_H
