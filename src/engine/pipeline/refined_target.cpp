// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_method_options.h"
#include "describe_fields.h"
#include "../surface/root_of_area.h"
#include "../support/Thread_limit.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Smacof_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

Target_3 refined_target(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                        const Landmark_fields_3& fields, const Point_matrix& pose,
                        const Method_options& options)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return refined_target(surface, coarse, fields, pose, options); });
  CANONICAL_POSE_3_PRECONDITION(pose.rows() == surface.points.rows());
  CANONICAL_POSE_3_PRECONDITION(fields.distances.rows() == coarse.surface.points.rows());
  const Surface_component_3 posed = coarse.posed(pose);
  const double size = internal::root_of_area(posed.points, posed.triangles);
  Landmark_fields_3 scaled = fields;
  if(size > 0)
    scaled.distances
      *= internal::root_of_area(coarse.surface.points, coarse.surface.triangles) / size;
  Smacof_target_builder_3 builder;
  builder.build(scaled, posed.points,
                vertex_area_shares(coarse.surface.points, coarse.surface.triangles));
  Target_3 target;
  target.points = align_target(coarse.interpolated(builder.targets()), surface.points,
                               vertex_area_shares(surface.points, surface.triangles));
  target.summary.kernel = "smacof";
  target.summary.stress = builder.stress();
  internal::describe_fields(fields, options, target.summary);
  return target;
}

} // namespace Canonical_pose_3
} // namespace CGAL
