// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command describe.

#include "Output_files.h"
#include "Report.h"
#include "command_options.h"
#include "commands.h"
#include "describe_shape.h"
#include "descriptors.h"
#include "shown_results.h"
#include "formats/Mesh_file.h"

#include <cstdlib>
#include <ostream>
#include <vector>

namespace Canonical_pose_tool {

namespace {

void add_describe_options(Command_options& o)
{
  add_input(o, Shapes::SURFACES);
  add_output(o, "the values of the descriptors (.json)");
  o.app
    .add_option("--descriptor", o.arguments.descriptors,
                "heat-kernel-quantiles, shape-dna, shape-distribution-d2, views; may be repeated; "
                "default: all")
    ->allow_extra_args(false);
  add_given_pose(o);
  add_method_options_for_each_component(o);
}

int run_describe(Arguments& arguments)
{
  check_extension(arguments.output, ".json");
  Output_files files({arguments.output});
  const std::vector<Descriptor> chosen = descriptors(arguments.descriptors);
  const Shape_description shape
    = describe_shape(read_mesh_file(arguments.input), chosen, arguments);
  files.write(arguments.output,
              [&](std::ostream& out) { write_descriptors(out, shape.descriptors); });
  files.commit();
  return EXIT_SUCCESS;
}

} // namespace

const Command DESCRIBE_COMMAND
  = {"describe",
     "describes a surface by numbers, for search",
     {"describe man.off -o man.json",
      "describe man.off -o man.json --descriptor views --pose pose.off"},
     add_describe_options,
     run_describe};

} // namespace Canonical_pose_tool
