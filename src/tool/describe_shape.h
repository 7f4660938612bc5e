// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_DESCRIBE_SHAPE_H
#define CGAL_CANONICAL_POSE_3_TOOL_DESCRIBE_SHAPE_H

#include "Command_line.h"
#include "Report.h"
#include "descriptors.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <optional>
#include <vector>

namespace Canonical_pose_tool {

struct Shape_description
{
  CGAL::Canonical_pose_3::Point_matrix points;
  CGAL::Canonical_pose_3::Point_matrix pose;                           // empty if none was needed
  std::optional<CGAL::Canonical_pose_3::Registration_summary> summary; // if the pose was computed
  std::vector<Described_shape> descriptors;
};

// Describes a surface, in its canonical pose, or in that of the arguments, if a descriptor needs one or
// `needs_pose`. Throws std::invalid_argument if the mesh is not a surface.
Shape_description describe_shape(const Mesh_file& input, const std::vector<Descriptor>& chosen,
                                 const Arguments& arguments, bool needs_pose = false);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_DESCRIBE_SHAPE_H
