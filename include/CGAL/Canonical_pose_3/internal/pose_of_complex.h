// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_POSE_OF_COMPLEX_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_POSE_OF_COMPLEX_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/internal/configuration.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/Canonical_pose_pipeline.h>
#include <CGAL/Canonical_pose_3/internal/boundary_triangles.h>
#include <CGAL/Canonical_pose_3/internal/inline_definition.h>
#include <CGAL/Canonical_pose_3/internal/with_solver.h>

#include <CGAL/Real_timer.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// canonical_pose_3() for tetrahedra, which are the body; its boundary must be connected. `pose`: of all
// points.
CGAL_CANONICAL_POSE_3_DEFINITION Registration_summary
pose_of_complex(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                const Options& options, Point_matrix& pose)
{
  Real_timer timer;
  timer.start();
  const Conforming_body_3 body(points, cells, static_cast<std::size_t>(points.rows()));
  Repaired_surface_3 surface;
  surface.triangles = boundary_triangles(body.points(), body.cells());
  make_boundary_manifold(surface.triangles, surface.origins);
  surface.points.resize(static_cast<Eigen::Index>(surface.origins.size()), 3);
  for(std::size_t i = 0; i < surface.origins.size(); ++i)
    surface.points.row(static_cast<Eigen::Index>(i))
      = body.points().row(static_cast<Eigen::Index>(surface.origins[i]));
  const double seconds_for_body = timer.time();
  const Diagnosis_3 diagnosis = diagnose(surface.points, surface.triangles);
  if(diagnosis.components > 1)
    throw std::invalid_argument("the boundary of the complex has "
                                + std::to_string(diagnosis.components) + " connected components");
  timer.stop();
  Registration_summary summary = with_solver(options, [&](const auto factor_traits) {
    typedef std::decay_t<decltype(factor_traits)> Factor_traits;
    return Canonical_pose_pipeline<Factor_traits>(surface, options, diagnosis)
      .run(body, surface.origins, pose);
  });
  summary.add_seconds("diagnosis", timer.time() - seconds_for_body);
  summary.add_seconds("body", seconds_for_body);
  return summary;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_POSE_OF_COMPLEX_H
