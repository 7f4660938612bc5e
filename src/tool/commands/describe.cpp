// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command describe.

#include "Output_files.h"
#include "Report.h"
#include "commands.h"
#include "describe_shape.h"
#include "descriptors.h"
#include "formats/Mesh_file.h"

#include <ostream>
#include <vector>

namespace Canonical_pose_tool {

void run_describe(const Arguments& arguments)
{
  Output_files files({arguments.output});
  const std::vector<Descriptor> chosen = descriptors(arguments.descriptors);
  const Shape_description shape
    = describe_shape(read_mesh_file(arguments.input), chosen, arguments);
  files.write(arguments.output,
              [&](std::ostream& out) { write_descriptors(out, shape.descriptors); });
  files.commit();
}

} // namespace Canonical_pose_tool
