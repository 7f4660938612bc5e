// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pose_of_components.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/body_of_surface.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/poses.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Real_timer.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Result pose_of_surface(const Point_matrix& points, const Face_list& polygons,
                       const Options& options, const Body_makers& bodies)
{
  if(const Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return pose_of_surface(points, polygons, options, bodies); });
  Real_timer timer;
  timer.start();
  const Prepared_surface_3 prepared = prepare_surface(points, polygons, options);
  timer.stop();
  Result result = pose_of_components(
    prepared, options,
    [&](const std::size_t c, const Coarse_surface_3& coarse, const Landmark_fields_3& fields) {
      const auto& [surface, local_options] = prepared.components[c];
      return body_of_surface(surface, coarse, fields, local_options, bodies);
    });
  result.summary.add_seconds("diagnosis", timer.time());
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
