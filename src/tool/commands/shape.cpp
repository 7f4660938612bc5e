// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command shape, which the command collection runs for each shape, as a process of its own.

#include "Output_files.h"
#include "Report.h"
#include "command_options.h"
#include "commands.h"
#include "describe_shape.h"
#include "descriptors.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/diagnose.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <vector>

namespace Canonical_pose_tool {

namespace {

void add_shape_options(Command_options& o)
{
  add_input(o);
  add_path(o, "-o,--output", o.arguments.output, "the pose");
  o.app.add_option("--descriptor", o.arguments.descriptors, "a descriptor")
    ->allow_extra_args(false);
  o.app.add_flag("--no-descriptor", o.arguments.has_no_descriptor, "none");
  o.app.add_flag("--segment", o.arguments.is_segmented, "parts");
  add_method_options_for_each_component(o);
}

int run_shape(Arguments& arguments)
{
  namespace CP = CGAL::Canonical_pose_3;
  Stage_clock clock;
  Output_files files({arguments.output}, {arguments.input});
  const std::vector<Descriptor> chosen
    = arguments.has_no_descriptor ? std::vector<Descriptor>() : descriptors(arguments.descriptors);
  Mesh_file input
    = read_mesh_file(arguments.input, arguments.output.empty() ? Source::DROPPED : Source::KEPT);
  if(!arguments.output.empty())
    load_appearance_for(input, format_of(arguments.output));
  const double seconds_to_read = clock.lap();
  Shape_description shape
    = describe_shape(input, chosen, arguments, arguments.is_segmented || !arguments.output.empty());
  std::vector<std::size_t> parts;
  if(arguments.is_segmented)
  {
    CP::Segmentation_options options;
    options.number_of_threads = arguments.options.number_of_threads;
    parts = CP::consensus_segmentation_tree(shape.points, input.faces, shape.pose, options).parts();
  }
  files.write_with_files(arguments.output, [&](std::ostream& out, Companion_files* const beside) {
    write_pose(out, format_of(arguments.output), input, shape.pose, beside);
  });
  files.commit();

  std::ostringstream report, values;
  if(shape.summary)
  {
    if(!arguments.output.empty())
      add_losses_of_file(shape.summary->warnings, "the pose", input, arguments.output);
    shape.summary->stages.insert(shape.summary->stages.begin(), {"read", seconds_to_read});
    write_report(report, *shape.summary, clock.total());
  }
  else
    write_report(report, CP::diagnose(shape.points, input.faces), {{"read", seconds_to_read}},
                 clock.total());
  write_descriptors(values, shape.descriptors);
  std::cout << nlohmann::ordered_json{{"report", nlohmann::ordered_json::parse(report.str())},
                                      {"descriptors", nlohmann::ordered_json::parse(values.str())},
                                      {"parts", parts}};
  return EXIT_SUCCESS;
}

} // namespace

const Command SHAPE_COMMAND = {"shape", "", {}, add_shape_options, run_shape};

} // namespace Canonical_pose_tool
