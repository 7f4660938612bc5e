// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists the joints of a shape: the centroids of the boundaries between its parts.
// Usage: joints input.off

#include <CGAL/Canonical_pose_3/segmentation_parts.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace CP = CGAL::Canonical_pose_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  Mesh mesh;
  if(argc < 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;
  auto ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  CP::sweep_segmentation(mesh, ids);

  const auto parts = CP::segmentation_parts(mesh, ids);
  for(std::size_t part = 0; part < parts.size(); ++part)
    for(const auto& neighbor : parts[part].neighbors)
      if(part < neighbor.part)
        std::cout << part << " and " << neighbor.part << " meet at " << neighbor.boundary_centroid
                  << '\n';
  return EXIT_SUCCESS;
}
catch(const std::exception& e)
{
  std::cerr << e.what() << '\n';
  return EXIT_FAILURE;
}
