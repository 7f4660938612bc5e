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
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Complex_parts.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Component_poses.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Factor_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Solver.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/component_body.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_component.h>
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

// canonical_pose_3() for tetrahedra, which are the body.
CGAL_CANONICAL_POSE_3_INLINE Result pose_of_complex(const Point_matrix& points,
                                                    const std::vector<std::array<int, 4>>& cells,
                                                    const Options& options,
                                                    const Factor_makers& given_solver)
{
  const Thread_limit limit(options);
  const Solver solver(options, given_solver);
  check_options(options, static_cast<std::size_t>(points.rows()));
  checked_stiffness(options.stiffness, cells.size());
  Real_timer timer;
  timer.start();
  const Conforming_body_3 body(points, cells, static_cast<std::size_t>(points.rows()));
  const Complex_parts parts(body.points(), body.cells(), body.cell_weights());
  const std::vector<Complex_part> posed_parts = parts_to_pose(parts, options);
  const double seconds_for_body = timer.time();
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

  Result result = poses.run([&](const std::size_t c, const Component_values& values) {
    const Complex_part& part = posed_parts[c];
    const auto make_body = [&](const Landmark_fields_3&, const Eigen::VectorXd&) {
      Eigen::VectorXd stiffness;
      if(options.stiffness.size() > 0)
        stiffness = Component_poses::values_at(options.stiffness, part.cells);
      return Component_body{"complex",
                            Conforming_body_3(rows_of(points, part.component.vertices),
                                              parts.local_cells(part),
                                              part.component.vertices.size()),
                            part.surface_vertices,
                            std::move(stiffness),
                            {}};
    };
    return pose_of_component(part.component, values, options, solver, make_body, diagnosis);
  });
  result.summary.add_seconds("diagnosis", seconds_for_diagnosis);
  result.summary.add_seconds("body", seconds_for_body);
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPLEX_IMPL_H
