// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPLEX_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPLEX_IMPL_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Canonical_pose_pipeline.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Complex_parts.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Component_poses.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Solver.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/poses.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/Real_timer.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The parts of a complex that the options ask for.
inline std::vector<Complex_part> parts_to_pose(const Complex_parts& parts, const Options& options)
{
  if(parts.size() > 1 && options.components == Options::Components::REFUSE)
    throw std::invalid_argument("the complex has " + std::to_string(parts.size())
                                + " connected components");
  std::vector<Complex_part> result;
  for(std::size_t i = 0; i < parts.size(); ++i)
    if(i == 0 || options.components == Options::Components::EACH)
      result.push_back(parts[i]);
  return result;
}

inline Point_matrix rows_of(const Point_matrix& points, const std::vector<std::size_t>& rows)
{
  Point_matrix result(static_cast<Eigen::Index>(rows.size()), 3);
  for(std::size_t i = 0; i < rows.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = points.row(static_cast<Eigen::Index>(rows[i]));
  return result;
}

// canonical_pose_3() for tetrahedra, which are the body. `pose`: of all points.
CGAL_CANONICAL_POSE_3_INLINE Registration_summary
pose_of_complex(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                const Options& options, Point_matrix& pose)
{
  const Thread_limit limit(options);
  const Solver solver(options);
  check_options(options, static_cast<std::size_t>(points.rows()));
  checked_stiffness(options.stiffness, cells.size());
  Real_timer timer;
  timer.start();
  const Conforming_body_3 body(points, cells, static_cast<std::size_t>(points.rows()));
  const Complex_parts parts(body.points(), body.cells(), body.cell_weights());
  const std::vector<Complex_part> posed_parts = parts_to_pose(parts, options);
  double seconds_for_body = timer.time();
  const Diagnosis_3 diagnosis = diagnose(parts.boundary_points(), parts.boundary_triangles());
  std::vector<Posed_component> components;
  for(const Complex_part& part : posed_parts)
    components.push_back(part.component);
  std::vector<std::vector<std::size_t>> others;
  for(std::size_t i = posed_parts.size(); i < parts.size(); ++i)
    others.push_back(parts[i].component.vertices);
  Component_poses poses(points, {{}, parts.boundary_vertices(), "boundary vertex"}, components,
                        others, options);
  const double seconds_for_diagnosis = timer.time() - seconds_for_body;

  Registration_summary summary = poses.run(
    [&](const std::size_t c, Options local_options) -> Component_result {
      const Complex_part& part = posed_parts[c];
      Real_timer body_timer;
      body_timer.start();
      const Conforming_body_3 body_of_part(rows_of(points, part.component.vertices),
                                           parts.local_cells(part), part.component.vertices.size());
      seconds_for_body += body_timer.time();
      if(options.stiffness.size() > 0)
        local_options.stiffness = Component_poses::values_at(options.stiffness, part.cells);
      Canonical_pose_pipeline pipeline(part.component, local_options, solver, Body_makers(),
                                       diagnosis);
      Point_matrix pose_of_part;
      const Registration_summary one
        = pipeline.run(body_of_part, part.surface_vertices, pose_of_part);
      return {one, std::move(pose_of_part), std::move(pipeline.results())};
    },
    pose);
  summary.add_seconds("diagnosis", seconds_for_diagnosis);
  summary.add_seconds("body", seconds_for_body);
  return summary;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPLEX_IMPL_H
