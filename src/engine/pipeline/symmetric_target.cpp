// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../support/precondition.h"
#include "../target/intrinsic_symmetry.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Intrinsic_symmetry_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

inline Eigen::VectorXd shares_of_coarse_vertices(const Coarse_surface_3& coarse)
{
  return vertex_area_shares(coarse.surface.points, coarse.surface.triangles);
}

} // namespace internal

std::optional<Intrinsic_symmetry_3> intrinsic_symmetry(const Coarse_surface_3& coarse,
                                                       const Landmark_fields_3& fields,
                                                       const Point_matrix& pose)
{
  CANONICAL_POSE_3_PRECONDITION(fields.distances.rows() == coarse.surface.points.rows());
  CANONICAL_POSE_3_PRECONDITION(pose.rows()
                                == static_cast<Eigen::Index>(coarse.number_of_surface_vertices()));
  return internal::symmetry_of_pose(fields, internal::rows_at(pose, coarse.vertices),
                                    internal::shares_of_coarse_vertices(coarse));
}

Point_matrix symmetric_target(const Coarse_surface_3& coarse, const Intrinsic_symmetry_3& symmetry,
                              const Point_matrix& target)
{
  CANONICAL_POSE_3_PRECONDITION(symmetry.images.size() == coarse.vertices.size());
  CANONICAL_POSE_3_PRECONDITION(target.rows()
                                == static_cast<Eigen::Index>(coarse.number_of_surface_vertices()));
  constexpr double least_change = .3; // in lengths of an edge, since images are vertices
  const Point_matrix points = internal::rows_at(target, coarse.vertices);
  double length = 0;
  for(const auto& triangle : coarse.surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      length += (points.row(static_cast<Eigen::Index>(triangle[k]))
                 - points.row(static_cast<Eigen::Index>(triangle[(k + 1) % 3])))
                  .norm();
  length /= 3 * static_cast<double>(coarse.surface.triangles.size());
  const Point_matrix changes
    = internal::symmetric_pose(points, symmetry.images, internal::shares_of_coarse_vertices(coarse))
      - points;
  if(!(std::sqrt(changes.rowwise().squaredNorm().mean()) > least_change * length))
    return target;
  return target + coarse.interpolated(changes);
}

} // namespace Canonical_pose_3
} // namespace CGAL
