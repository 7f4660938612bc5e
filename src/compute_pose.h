// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_POSE_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_POSE_H

#include "Cgal_types.h"
#include "Mesh_file.h"
#include "Report.h"

#include <CGAL/canonical_pose_3.h>

#include <stdexcept>
#include <vector>

namespace Canonical_pose_tool {

using CGAL::Canonical_pose_3::Options;
using CGAL::Canonical_pose_3::Registration_summary;

// `pose` receives one row per vertex of `input`.
inline Registration_summary compute_pose(const Mesh_file& input, const Options& options,
                                         Point_matrix& pose)
{
  Stage_clock clock;
  double seconds_to_convert; // and to find that it can be done
  Registration_summary summary;
  if(input.is_tetrahedral)
  {
    const Tetrahedra complex = tetrahedra_of(input);
    seconds_to_convert = clock.lap();
    std::vector<Point_3> points(complex.points.size());
    summary = CGAL::canonical_pose_3(complex, CGAL::make_property_map(points), options);
    pose = matrix_of(points);
  }
  else
  {
    const std::vector<Point_3> points = points_of(input);
    seconds_to_convert = clock.lap();
    std::vector<Point_3> pose_points;
    summary = CGAL::canonical_pose_3(points, input.faces, pose_points, options);
    pose = matrix_of(pose_points);
  }
  if(!summary.is_usable())
    throw std::runtime_error("there is no pose: the registration met numbers that are not finite");
  summary.add_seconds("diagnosis", seconds_to_convert);
  return summary;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_POSE_H
