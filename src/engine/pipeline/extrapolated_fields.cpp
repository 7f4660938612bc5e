// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../surface/root_of_area.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

Landmark_fields_3 extrapolated_fields(const Coarse_surface_3& coarse,
                                      const Landmark_fields_3& fields,
                                      const Landmark_fields_3& fields_of_pose,
                                      const Point_matrix& pose, const double factor)
{
  CANONICAL_POSE_3_PRECONDITION(fields.landmarks == fields_of_pose.landmarks);
  CANONICAL_POSE_3_PRECONDITION(fields.distances.rows() == coarse.surface.points.rows());
  CANONICAL_POSE_3_PRECONDITION(fields_of_pose.distances.rows() == coarse.surface.points.rows());
  CANONICAL_POSE_3_PRECONDITION(std::isfinite(factor) && factor >= 0);
  const Surface_component_3 posed = coarse.posed(pose);
  const double size = internal::root_of_area(coarse.surface.points, coarse.surface.triangles);
  const double scale = size > 0 ? internal::root_of_area(posed.points, posed.triangles) / size : 1;
  const Eigen::MatrixXd change = fields_of_pose.distances - scale * fields.distances;
  const Eigen::VectorXd shares
    = vertex_area_shares(coarse.surface.points, coarse.surface.triangles);
  const Eigen::VectorXd of_vertices = change.rowwise().mean();
  const Eigen::RowVectorXd of_landmarks = shares.transpose() * change;
  Landmark_fields_3 result = fields_of_pose;
  result.distances += factor
                      * ((change.colwise() - of_vertices).rowwise()
                         - (of_landmarks.array() - of_vertices.dot(shares)).matrix());
  result.distances = result.distances.cwiseMax(0).eval();
  for(std::size_t j = 0; j < result.landmarks.size(); ++j)
    result.distances(static_cast<Eigen::Index>(result.landmarks[j]), static_cast<Eigen::Index>(j))
      = 0;
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
