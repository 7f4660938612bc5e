// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The command describe.

#include "Cgal_types.h"
#include "Mesh_file.h"
#include "Output_files.h"
#include "Report.h"
#include "commands.h"
#include "compute_pose.h"
#include "descriptors.h"
#include "exact_geodesics.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

Point_matrix pose_of(const Mesh_file& input, const Point_matrix& points, const Arguments& arguments)
{
  if(!arguments.pose.empty())
  {
    const Point_matrix pose = matrix_of(points_of(read_mesh_file(arguments.pose)));
    if(pose.rows() != points.rows())
      throw std::invalid_argument("the pose has " + std::to_string(pose.rows())
                                  + " vertices, but the surface has "
                                  + std::to_string(points.rows()));
    return pose;
  }
  Options options = arguments.options;
  if(arguments.geodesics == "exact")
    options.landmark_fields_function = exact_landmark_fields();
  return compute_pose(input, options).pose;
}

} // namespace

void run_describe(const Arguments& arguments)
{
  Output_files files({arguments.output});
  const std::vector<Descriptor> chosen = descriptors(arguments.descriptors);
  const Mesh_file input = read_mesh_file(arguments.input);
  if(input.is_tetrahedral)
    throw std::invalid_argument("a surface is needed, but this is a tetrahedral mesh");
  const Point_matrix points = matrix_of(points_of(input));
  const bool needs_pose
    = std::any_of(chosen.begin(), chosen.end(), [](const Descriptor& d) { return d.needs_pose; });
  const Point_matrix pose = needs_pose ? pose_of(input, points, arguments) : Point_matrix(0, 3);
  std::vector<Described_shape> described;
  for(const Descriptor& d : chosen)
    described.push_back({d.name, d.version, d.values(d.needs_pose ? pose : points, input.faces)});
  files.write(arguments.output, [&](std::ostream& out) { write_descriptors(out, described); });
  files.commit();
}

} // namespace Canonical_pose_tool
