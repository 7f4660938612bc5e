// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_method_options.h"
#include "describe_fields.h"
#include "../surface/closed.h"
#include "../support/Thread_limit.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Mds_kernel.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Squared_distance_kernel.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

inline Mds_kernel kernel_of(const Method_options& options)
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

// By multidimensional scaling, neither aligned nor reflected.
inline Target_3 embedded_target(const Landmark_fields_3& fields, const Mds_kernel& kernel)
{
  Landmark_mds_target_builder_3<Mds_kernel> builder(kernel);
  builder.build(fields);
  Target_3 target;
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

} // namespace internal

Target_3 mds_target(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                    const Landmark_fields_3& fields, const Component_options& options)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return mds_target(surface, coarse, fields, options); });
  CANONICAL_POSE_3_PRECONDITION(coarse.number_of_surface_vertices()
                                == static_cast<std::size_t>(surface.points.rows()));
  CANONICAL_POSE_3_PRECONDITION(fields.distances.rows() == coarse.surface.points.rows());
  Target_3 target;
  if(options.given.target)
  {
    target.points = *options.given.target;
    target.is_given = true;
    target.summary.kernel = "given";
  }
  else
  {
    target = internal::embedded_target(fields, internal::kernel_of(options));
    target.points = coarse.interpolated(target.points);
    const Eigen::VectorXd shares = vertex_area_shares(surface.points, surface.triangles);
    const Target_handedness_3 handedness
      = target_handedness(target.points, surface.points, internal::closed(surface), shares);
    target.summary.reflected = handedness.is_mirror_image() != options.takes_mirror_image;
    target.summary.is_handedness_certain = handedness.is_certain();
    target.points = align_target(target.points, surface.points, shares, target.summary.reflected);
  }
  internal::describe_fields(fields, options, target.summary);
  return target;
}

} // namespace Canonical_pose_3
} // namespace CGAL
