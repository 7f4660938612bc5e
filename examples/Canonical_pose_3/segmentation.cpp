// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Divides a surface into parts, and colors them.
// Usage: segmentation input.off [output.ply]

#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  Mesh mesh;
  if(argc < 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;
  auto pose = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:pose").first;
  if(!CGAL::canonical_pose_3(mesh, pose).is_usable())
    return EXIT_FAILURE;
  auto parts = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  std::cout << CGAL::Canonical_pose_3::consensus_segmentation(mesh, pose, parts) << " parts\n";

  auto colors = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for(const Mesh::Face_index f : mesh.faces())
    colors[f].set_hsv(static_cast<double>(parts[f] * 137 % 360), 60, 90);
  return argc > 2 && !CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_FAILURE : EXIT_SUCCESS;
}
catch(const std::exception& e)
{
  std::cerr << e.what() << '\n';
  return EXIT_FAILURE;
}
