// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Brings a closed surface into its canonical pose: a mesh file if one is given, otherwise the
// sitting figure. Usage: canonical_pose [input.off [pose.off]]

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <cstdlib>
#include <exception>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Canonical_pose_examples::Articulated_figure;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    mesh = Articulated_figure(2500).make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles);
  else if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "cannot read " << argv[1] << '\n';
    return EXIT_FAILURE;
  }

  auto pose = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:pose").first;
  try
  {
    const auto summary = CGAL::canonical_pose_3(mesh, pose).summary;
    std::cout << summary << '\n';
    if(!summary.is_usable())
      return EXIT_FAILURE;
  }
  catch(const std::exception& e) // the surface is not closed, or intersects itself, ...
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }

  for(const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = pose[v];
  if(argc > 2
     && !CGAL::IO::write_polygon_mesh(argv[2], mesh, CGAL::parameters::stream_precision(17)))
    return EXIT_FAILURE;
  return EXIT_SUCCESS;
}
