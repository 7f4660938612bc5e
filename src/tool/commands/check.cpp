// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command check.

#include "Output_files.h"
#include "Report.h"
#include "commands.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <iostream>

namespace Canonical_pose_tool {

void run_check(const Arguments& arguments)
{
  Stage_clock clock;
  Output_files files({arguments.report});
  const Mesh_file input = read_mesh_file(arguments.input);
  const double seconds_to_read = clock.lap();
  const auto diagnosis = diagnosis_of(input);
  const double seconds_to_diagnose = clock.lap();
  files.write(arguments.report, [&](std::ostream& out) {
    write_report(out, diagnosis, {{"read", seconds_to_read}, {"diagnosis", seconds_to_diagnose}},
                 clock.total());
  });
  files.commit();
  if(!arguments.quiet)
    write_table(std::cout, diagnosis);
}

} // namespace Canonical_pose_tool
