// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_POSE_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_POSE_H

#include "Report.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/canonical_pose_3.h>

#include <stdexcept>
#include <vector>

namespace Canonical_pose_tool {

using CGAL::Canonical_pose_3::Options;
using CGAL::Canonical_pose_3::Result;

// Throws `std::runtime_error` if there is no pose.
inline Result compute_pose(const Mesh_file& input, const Options& options)
{
  Stage_clock clock;
  double seconds_to_convert; // includes checking the input
  Result result;
  if(input.is_tetrahedral)
  {
    const Tetrahedra complex = tetrahedra_of(input);
    seconds_to_convert = clock.lap();
    std::vector<Point_3> points(complex.points.size());
    result = CGAL::canonical_pose_3(complex, CGAL::make_property_map(points), options);
  }
  else
  {
    const std::vector<Point_3> points = points_of(input);
    seconds_to_convert = clock.lap();
    std::vector<Point_3> pose;
    result = CGAL::canonical_pose_3(points, input.faces, pose, options);
  }
  if(!result.is_usable())
    throw std::runtime_error("there is no pose: the registration met numbers that are not finite");
  result.summary.add_seconds("diagnosis", seconds_to_convert);
  return result;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_POSE_H
