// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_TARGET_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_TARGET_H

#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Mds_kernel.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Squared_distance_kernel.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Where a component is to go.
struct Component_target
{
  Point_matrix points; // of its vertices
  bool is_given = false;
  Registration_summary::Target summary;
  std::vector<std::string> warnings;
};

inline Mds_kernel kernel_of(const Options& options)
{
  if(options.mds_kernel)
    return *options.mds_kernel;
  switch(options.kernel)
  {
  case Options::Kernel::GAUSSIAN:
    return Gaussian_kernel();
  case Options::Kernel::UNCENTERED_GAUSSIAN:
    return Gaussian_kernel(false);
  default:
    return Squared_distance_kernel();
  }
}

// The target by multidimensional scaling, neither aligned nor reflected.
inline Component_target embedded_target(const Landmark_fields_3& fields, const Mds_kernel& kernel)
{
  Landmark_mds_target_builder_3<Mds_kernel> builder(kernel);
  builder.build(fields);
  Component_target target;
  target.points = builder.targets();
  target.summary.kernel = kernel.name();
  target.summary.stress = builder.stress();
  const Eigen::VectorXd& values = builder.eigenvalues();
  target.summary.eigenvalues.assign(values.data(),
                                    values.data() + (std::min)(Eigen::Index(6), values.size()));
  if(builder.number_of_positive_eigenvalues() < 3)
    target.warnings.push_back("the target is flat: fewer than three eigenvalues are positive");
  if(!builder.is_determined())
    target.warnings.push_back(
      "the pose is not determined: the fourth eigenvalue is nearly as large as the third");
  return target;
}

// The target of a component, aligned with it and of its handedness, unless it is given. `shares`: of its vertices in
// the area.
inline Component_target component_target(const Posed_component& component,
                                         const Landmark_fields_3& fields,
                                         const std::optional<Point_matrix>& given,
                                         const Options& options, const Eigen::VectorXd& shares)
{
  Component_target target;
  if(given)
  {
    target.points = *given;
    target.is_given = true;
    target.summary.kernel = "given";
  }
  else
  {
    target = embedded_target(fields, kernel_of(options));
    std::vector<Index_triangle> closed = component.triangles;
    closed.insert(closed.end(), component.caps.begin(), component.caps.end());
    target.summary.reflected
      = target_handedness(target.points, component.points, closed, shares) < 0;
    target.points = align_target(target.points, component.points, shares, target.summary.reflected);
  }
  target.summary.landmarks = fields.landmarks.size();
  target.summary.covering_radius = fields.covering_radius;
  target.summary.max_geodesic = fields.distances.maxCoeff();
  return target;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_TARGET_H
