// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command match.

#include "Output_files.h"
#include "Report.h"
#include "command_options.h"
#include "commands.h"
#include "compute_pose.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"
#include "formats/Shortest_numbers.h"

#include <CGAL/Canonical_pose_3/match_surfaces.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace CP = CGAL::Canonical_pose_3;

void add_match_options(Command_options& o)
{
  add_input(o, Shapes::SURFACES);
  add_path(o, "OTHER", o.arguments.other, "the surface with which it is matched")->required();
  add_output(
    o,
    "where the vertices of INPUT are on OTHER: a line each (.txt), or INPUT in the shape of OTHER",
    {"txt", "off", "obj", "ply", "stl", "glb"});
  add_given_pose(o);
  add_path(o, "--other-pose", o.arguments.other_pose, "the same for OTHER");
  o.app
    .add_option("--landmark", o.raw.landmarks,
                "I,J: vertex I of INPUT matches vertex J of OTHER; may be repeated")
    ->allow_extra_args(false);
  add_report(o);
  add_method_options_for_each_component(o);
}

CP::Matchable_surface_3 prepared(const Mesh_file& mesh, const std::string& pose,
                                 const Arguments& arguments)
{
  check_is_surface(mesh);
  const Point_matrix points = matrix_of(points_of(mesh));
  return {points, mesh.faces,
          pose.empty() ? compute_pose(mesh, watched_options(arguments)).pose
                       : matrix_of(points_of(read_other_mesh_file(pose)))};
}

void write_locations(std::ostream& out, const CP::Surface_match_3& match)
{
  use_shortest_numbers(out);
  for(const auto& [face, vertices, weights] : match.locations)
  {
    out << face;
    for(const std::size_t v : vertices)
      out << ' ' << v;
    for(const double weight : weights)
      out << ' ' << weight;
    out << '\n';
  }
}

int run_match(Arguments& arguments)
{
  Stage_clock clock;
  const std::string& output = arguments.output;
  const bool is_map = is_text(output);
  if(const Format format = is_map ? Format::OFF : format_of_output(output);
     format == Format::MEDIT || format == Format::VTU)
    throw Usage_error("the output is a surface or a text file");
  const std::vector<std::string> outputs = {output, arguments.report};
  Output_files files(outputs,
                     {arguments.input, arguments.other, arguments.pose, arguments.other_pose});
  const Mesh_file input
    = is_map ? read_mesh_file(arguments.input) : read_shown_mesh_file(arguments.input);
  if(!is_map)
    check_format_holds(format_of(output), input);
  const Mesh_file other = read_other_mesh_file(arguments.other);
  std::vector<CP::Registration_summary::Stage> stages = {{"read", clock.lap()}};
  arguments.say("computing the poses");
  const CP::Matchable_surface_3 surface = prepared(input, arguments.pose, arguments),
                                surface_of_other = prepared(other, arguments.other_pose, arguments);
  stages.emplace_back("poses", clock.lap());
  arguments.say("matching");
  arguments.match.number_of_threads = arguments.options.number_of_threads;
  const CP::Surface_match_3 match = CP::match_surfaces(surface, surface_of_other, arguments.match);
  stages.emplace_back("match", clock.lap());
  std::vector<std::string> warnings;
  if(!is_map)
    warnings = loss_warnings(input, output, "the surface");
  if(!match.is_rotation_certain)
    warnings.push_back(
      "another rotation of the pose matches nearly as well: front and back may be confused");
  files.write(output, [&](std::ostream& out) {
    if(is_map)
      return write_locations(out, match);
    write_pose(out, format_of(output), input, match.interpolated(matrix_of(points_of(other))));
  });
  stages.emplace_back("write", clock.lap());
  files.write(arguments.report, [&](std::ostream& out) {
    write_report(out, match, warnings, stages, clock.total());
  });
  files.commit();
  arguments.say("");
  if(arguments.quiet)
    return EXIT_SUCCESS;
  std::ostream& out = messages_beside(outputs);
  out << "mean round trip " << match.round_trips.mean() << ", mean distance of the poses "
      << match.mean_distance << " (of their radius)\n";
  for(const std::string& warning : warnings)
    out << "warning: " << warning << '\n';
  return EXIT_SUCCESS;
}

} // namespace

const Command MATCH_COMMAND
  = {"match",
     "finds where the vertices of a surface are on another one",
     {"match man.obj woman.ply -o map.txt", "match man.obj woman.ply -o man_as_woman.obj"},
     add_match_options,
     run_match};

} // namespace Canonical_pose_tool
