// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command geodesics.

#include "shown_results.h"
#include "Output_files.h"
#include "commands.h"
#include "exact_geodesics.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/geodesic_distances.h>

#include <Eigen/Core>

#include <ostream>
#include <stdexcept>

namespace Canonical_pose_tool {

void run_geodesics(const Arguments& arguments)
{
  check_format_of_values(arguments.output);
  Output_files files({arguments.output});
  const Mesh_file input = read_mesh_file(arguments.input);
  check_is_surface(input);
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
}

} // namespace Canonical_pose_tool
