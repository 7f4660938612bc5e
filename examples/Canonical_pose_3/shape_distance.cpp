// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints how different two shapes are, whatever their poses.
// Usage: shape_distance first.off second.off

#include <CGAL/Canonical_pose_3/Heat_kernel_quantiles_3.h>
#include <CGAL/Canonical_pose_3/shape_descriptor.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <exception>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh first, second;
  if(argc < 3 || !PMP::IO::read_polygon_mesh(argv[1], first)
     || !PMP::IO::read_polygon_mesh(argv[2], second))
    return EXIT_FAILURE;
  const CGAL::Canonical_pose_3::Heat_kernel_quantiles_3 descriptor;
  std::cout << descriptor.distances(shape_descriptor(descriptor, first),
                                    shape_descriptor(descriptor, second))
            << '\n';
  return EXIT_SUCCESS;
}
catch(const std::exception& e)
{
  std::cerr << e.what() << '\n';
  return EXIT_FAILURE;
}
