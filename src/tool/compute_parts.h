// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_PARTS_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_PARTS_H

#include "Report.h"
#include "compute_pose.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/k_means_segmentation.h>
#include <CGAL/Canonical_pose_3/segmentation_parts.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

using CGAL::Canonical_pose_3::Segmentation_options;

// What a segmentation starts from.
struct Segmentation_input
{
  const Mesh_file& surface;
  std::string method;
  std::optional<Point_matrix> pose; // computed if it is needed and not given
  Options options;                  // of the pose
  std::size_t number_of_parts;      // 0: automatic
};

// Returns the part of each face. If the pose cannot be computed, this is a warning.
inline std::vector<std::size_t> compute_parts(const Segmentation_input& input,
                                              Segmentation_report& report, Stage_clock& clock)
{
  namespace CP = CGAL::Canonical_pose_3;
  Segmentation_options options;
  options.number_of_parts = input.number_of_parts;
  options.random_seed = input.options.random_seed;
  options.number_of_threads = input.options.number_of_threads;
  report.method = input.method;
  Point_matrix pose = input.pose.value_or(Point_matrix(0, 3));
  if(!input.pose && input.method != "sweep")
    try
    {
      pose = compute_pose(input.surface, input.options).pose;
    }
    catch(const std::exception& error)
    {
      report.warnings.push_back(std::string("the pose does not vote: ") + error.what());
    }
  report.stages.emplace_back("pose", clock.lap());
  const Point_matrix points = matrix_of(points_of(input.surface));
  const CP::Face_list& faces = input.surface.faces;
  std::vector<std::size_t> parts;
  if(input.method == "kmeans")
    parts = CP::k_means_parts(pose.rows() > 0 ? pose : points, faces, options);
  else
  {
    report.tree = input.method == "sweep"
                    ? CP::sweep_segmentation_tree(points, faces, pose, options)
                    : CP::consensus_segmentation_tree(points, faces, pose, options);
    parts = report.tree->parts();
  }
  report.parts = CP::segmentation_parts(points, faces, parts);
  if(report.parts.size() < input.number_of_parts)
    report.warnings.push_back("the number of parts is " + std::to_string(report.parts.size())
                              + " instead of the " + std::to_string(input.number_of_parts)
                              + " requested: the surface is not divided further");
  report.stages.emplace_back("segmentation", clock.lap());
  return parts;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_PARTS_H
