// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_tables.h"

#include "Processor_clock.h"
#include "compute_pose.h" // of the tool
#include "paper_shapes.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace Canonical_pose_benchmark {

void print_weights_table(Argument_list& arguments)
{
  namespace CP = CGAL::Canonical_pose_3;
  using Canonical_pose_examples::Articulated_figure;
  const auto vertices = static_cast<std::size_t>(arguments.take_number("--vertices", 10000));
  const std::string prefix = arguments.take_text("--prefix");
  arguments.rest();

  Mesh_file mesh
    = mesh_of_figure(Articulated_figure(vertices), Articulated_figure::named_poses()[1].angles);
  for(auto& point : mesh.points)
    for(double& coordinate : point)
      coordinate *= 100; // centimeters, as TOSCA
  write_picture_mesh(prefix, "input", mesh, points_of_file(mesh));
  std::printf("| alpha | beta | distance from the target | median edge strain | volume | inverted "
              "| iterations | seconds |\n|---|---|---|---|---|---|---|---|\n");
  for(const auto& [alpha, beta] :
      {std::pair(1., 10.), std::pair(10., 10.), std::pair(100., 10.), std::pair(1000., 10.),
       std::pair(100., 0.), std::pair(100., 1.), std::pair(100., 100.)})
  {
    CP::Options options;
    options.kernel = CP::Options::Kernel::UNCENTERED_GAUSSIAN;
    options.body = CP::Options::Body::TETGEN;
    options.paper_weights = CP::Paper_weights{alpha, beta};
    const Processor_clock clock;
    const CP::Result result = Canonical_pose_tool::compute_pose(mesh, options);
    const double seconds = clock.seconds();
    const CP::Registration_summary& summary = result.summary;
    std::printf("| %g | %g | %.4f | %.3f | %.2f | %zu | %d%s | %.1f |\n", alpha, beta,
                std::sqrt((result.pose - *result.target).rowwise().squaredNorm().mean())
                  / summary.target.max_geodesic,
                summary.median_edge_strain, summary.volume_ratio, summary.inverted,
                summary.iterations, summary.converged() ? "" : " (limit)", seconds);
    std::fflush(stdout);
    write_picture_mesh(prefix,
                       "alpha" + std::to_string(static_cast<int>(alpha)) + "_beta"
                         + std::to_string(static_cast<int>(beta)),
                       mesh, result.pose);
    write_picture_mesh(prefix, "target", mesh, *result.target);
  }
}

} // namespace Canonical_pose_benchmark
