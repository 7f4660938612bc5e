// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_BODY_BODY_CELLS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_BODY_BODY_CELLS_H

#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <Eigen/LU>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Returns the cells around each vertex of a body, in the order of the cells.
inline Buckets<std::size_t> cells_of_vertices(const std::size_t number_of_vertices,
                                              const std::vector<std::array<int, 4>>& cells)
{
  return Buckets<std::size_t>(number_of_vertices, [&](const auto& put) {
    for(std::size_t t = 0; t < cells.size(); ++t)
      for(const int v : cells[t])
        put(static_cast<std::size_t>(v), t);
  });
}

// Returns the barycentric coordinates, with sum 1, of a point with respect to the corners of a
// tetrahedron.
inline Eigen::Vector4d barycentric_coordinates(const std::array<Eigen::Vector3d, 4>& corners,
                                               const Eigen::Vector3d& point)
{
  Eigen::Matrix3d edges;
  for(std::size_t k = 0; k < 3; ++k)
    edges.col(static_cast<Eigen::Index>(k)) = corners[k + 1] - corners[0];
  const Eigen::Vector3d x = edges.partialPivLu().solve(point - corners[0]);
  Eigen::Vector4d result;
  result << 1 - x.sum(), x;
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_BODY_BODY_CELLS_H
