// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_POSE_OF_TEMPLATE_H
#define CGAL_CANONICAL_POSE_3_TOOL_POSE_OF_TEMPLATE_H

#include "Command_line.h"
#include "Output_files.h"
#include "command_options.h"
#include "compute_pose.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/Matchable_surface_3.h>

#include <exception>
#include <stdexcept>
#include <string>

namespace Canonical_pose_tool {

// Computes the pose of the template with which shapes are matched, and writes it. Throws
// std::runtime_error, which names the template, if shapes cannot be matched with it.
inline void write_pose_of_template(const Arguments& arguments, const std::string& file)
{
  const std::string& path = arguments.match_template;
  Output_files files({file}, {path});
  Mesh_file mesh;
  Point_matrix pose;
  arguments.say("computing the pose of the template");
  try
  {
    mesh = read_mesh_file(path, Source::KEPT);
    check_is_surface(mesh);
    load_appearance_for(mesh, format_of(file));
    Options options = watched_options(arguments);
    options.number_of_threads = 0; // nothing else is computed now
    pose = compute_pose(mesh, options).pose;
    const CGAL::Canonical_pose_3::Matchable_surface_3 trial(matrix_of(points_of(mesh)), mesh.faces,
                                                            pose);
  }
  catch(const std::exception& error)
  {
    throw std::runtime_error("the template '" + path + "': " + error.what());
  }
  files.write_with_files(file, [&](std::ostream& out, Companion_files* const beside) {
    write_pose(out, format_of(file), mesh, pose, beside);
  });
  files.commit();
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_POSE_OF_TEMPLATE_H
