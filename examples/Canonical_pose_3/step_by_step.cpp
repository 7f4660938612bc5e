// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The steps of canonical_pose_3(), one after the other. Usage: step_by_step [input.off]

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>
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

  // Distances to 80 landmarks; the systems of the heat method are factored once.
  const CP::Heat_geodesics_3<Mesh> geodesics(mesh);
  const auto fields = CP::front_landmarks(geodesics, 80, CP::extremal_vertex(mesh, mesh.points()));
  std::cout << "covering radius of the landmarks: " << fields.covering_radius << '\n';
  // A target point for each vertex.
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(fields);
  std::cout << "stress of the target: " << builder.stress() << '\n';
  // Its position: moved onto the input, mirrored if that is its handedness.
  const auto points = CP::point_matrix(mesh);
  const auto shares = CP::vertex_area_shares(mesh, mesh.points());
  const bool mirrored = CP::target_handedness(builder.targets(), mesh, mesh.points()) < 0;
  const auto target = CP::align_target(builder.targets(), points, shares, mirrored);
  // Tetrahedra inside, and the registration.
  const CP::Lattice_body_3 body(mesh, mesh.points(), fields.distances);
  CP::Tetrahedral_arap_registrar_3 registrar(body, shares, builder.length_scale());
  registrar.set_target(target);
  CP::Point_matrix pose; // of all vertices of the body; empty: start from the target
  const auto summary = registrar.register_to_target(pose);
  std::cout << summary << '\n';
  if(!summary.is_usable())
    return EXIT_FAILURE;
  CP::put_points(registrar.surface_points(pose), mesh, mesh.points(), Kernel());
  return EXIT_SUCCESS;
}
