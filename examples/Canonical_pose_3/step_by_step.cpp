// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The individual steps of canonical_pose_3(); the registration is repeated with a larger detail
// length. Usage: step_by_step [input.off]

#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include "Articulated_figure.h"
#include <cstdlib>
#include <iostream>

namespace CP = CGAL::Canonical_pose_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    mesh = Canonical_pose_examples::Articulated_figure(2500).make_mesh<Mesh>();
  else if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;

  // Examined and repaired; the options are those of its only component.
  const CP::Prepared_surface_3 prepared = CP::prepare_surface(mesh);
  const CP::Surface_component_3& surface = prepared.components.front().surface;
  CP::Component_options options = prepared.components.front().options;

  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, options);
  const CP::Landmark_fields_3 fields = CP::landmark_fields(coarse, options);
  const CP::Target_3 target = CP::mds_target(surface, coarse, fields, options);
  const CP::Surface_body_3 body = CP::surface_body(surface, coarse, fields, options);
  const CP::Result registered = CP::registered_pose(surface, coarse, fields, target, body, options);
  const CP::Result result = CP::joined_result(prepared, {registered});

  std::cout << "vertices of the coarse surface: " << coarse.vertices.size() << '\n'
            << "covering radius of the landmarks: " << fields.covering_radius << '\n'
            << "stress of the first target: " << target.summary.stress << '\n';
  for(const auto& round : result.summary.rounds) // distances were measured again, on the pose
    std::cout << "stress of a refined target: " << round.stress << '\n';
  std::cout << result << '\n';
  if(!result.is_usable())
    return EXIT_FAILURE;
  CP::put_points(result.pose, mesh, mesh.points(), Kernel());

  // Distances, target and body can be reused with other options.
  options.registration.detail_length = 0.2;
  std::cout << CP::registered_pose(surface, coarse, fields, target, body, options) << '\n';
  return EXIT_SUCCESS;
}
