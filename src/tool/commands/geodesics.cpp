// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command geodesics.

#include "shown_results.h"
#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "exact_geodesics.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/geodesic_distances.h>

#include <Eigen/Core>

#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

void add_geodesics_options(Command_options& o)
{
  add_input(o, Shapes::SURFACES);
  o.app.add_option("--source", o.arguments.sources, "number of a vertex, from 0; may be repeated")
    ->required()
    ->transform(integer(std::size_t(0)))
    ->allow_extra_args(false);
  add_output(o, "the distances: a line per vertex, a column per source; or colors (.ply, .glb)",
             {"txt", "ply", "glb"});
  add_common(o);
}

int run_geodesics(Arguments& arguments)
{
  check_format_of_values(arguments.output);
  Output_files files({arguments.output}, {arguments.input});
  const Mesh_file input = is_shown(arguments.output) ? read_shown_mesh_file(arguments.input)
                                                     : read_mesh_file(arguments.input);
  check_is_surface(input);
  arguments.say("measuring distances");
  const bool is_exact = arguments.geodesics == "exact";
  const Eigen::MatrixXd distances = CGAL::Canonical_pose_3::geodesic_distances(
    matrix_of(points_of(input)), input.faces, arguments.sources, arguments.options,
    is_exact ? exact_distances : CGAL::Canonical_pose_3::Distances_function());
  files.write(arguments.output, [&](std::ostream& out) {
    if(is_shown(arguments.output))
      return write_shown(out, format_of(arguments.output), shown_distances(input, distances));
    out << distances.format(Eigen::IOFormat(17, Eigen::DontAlignCols, " ", "\n", "", "", "", "\n"));
  });
  files.commit();
  std::vector<std::string> warnings;
  if(is_shown(arguments.output))
    add_losses_of_shown(warnings, "the distances lack", input, arguments.output, true);
  if(!arguments.quiet)
    for(const std::string& warning : warnings)
      messages_beside({arguments.output}) << "warning: " << warning << '\n';
  return EXIT_SUCCESS;
}

} // namespace

const Command GEODESICS_COMMAND
  = {"geodesics",
     "measures distances on a surface",
     {"geodesics man.off --source 0 --source 17 -o distances.txt",
      "geodesics man.off --source 0 -o distances.glb --geodesics wavefront"},
     add_geodesics_options,
     run_geodesics};

} // namespace Canonical_pose_tool
