// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command check.

#include "Output_files.h"
#include "Report.h"
#include "command_options.h"
#include "commands.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <cstdlib>
#include <iostream>

namespace Canonical_pose_tool {

namespace {

void add_check_options(Command_options& o)
{
  add_input(o);
  add_report(o);
  add_quiet(o);
  o.app.add_flag("--strict", o.arguments.is_strict, "exit code 3 if there are defects");
}

int run_check(Arguments& arguments)
{
  Stage_clock clock;
  Output_files files({arguments.report}, {arguments.input});
  const Mesh_file input = read_mesh_file(arguments.input, Source::UNCHECKED);
  const double seconds_to_read = clock.lap();
  arguments.say("looking for defects");
  const auto diagnosis = diagnosis_of(input);
  const double seconds_to_diagnose = clock.lap();
  files.write(arguments.report, [&](std::ostream& out) {
    write_report(out, diagnosis, {{"read", seconds_to_read}, {"diagnosis", seconds_to_diagnose}},
                 clock.total());
  });
  files.commit();
  arguments.say("");
  if(!arguments.quiet)
    write_table(messages_beside({arguments.report}), diagnosis);
  return arguments.is_strict && !diagnosis.defects.empty() ? DEFECTS_FOUND : EXIT_SUCCESS;
}

} // namespace

const Command CHECK_COMMAND = {"check",
                               "lists the defects of a surface",
                               {"check man.off", "check man.off --report defects.json --quiet"},
                               add_check_options,
                               run_check};

} // namespace Canonical_pose_tool
