// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the surfaces of a folder that are like another surface.
// Usage: shape_search query.off folder

#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Heat_kernel_quantiles_3.h>
#include <CGAL/Canonical_pose_3/shape_descriptor.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
try
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh query;
  if(argc < 3 || !PMP::IO::read_polygon_mesh(argv[1], query))
    return EXIT_FAILURE;
  const CP::Heat_kernel_quantiles_3 descriptor;
  CP::Descriptor_index_3<CP::Heat_kernel_quantiles_3> index(descriptor);
  std::vector<std::string> paths;
  for(const auto& entry : std::filesystem::directory_iterator(argv[2]))
    if(Mesh mesh; entry.path().extension() == ".off"
                  && PMP::IO::read_polygon_mesh(entry.path().string(), mesh))
    {
      index.insert(shape_descriptor(descriptor, mesh));
      paths.push_back(entry.path().string());
    }
  constexpr std::size_t number_of_answers = 10;
  for(const auto& [shape, distance] :
      index.nearest(shape_descriptor(descriptor, query), number_of_answers))
    std::cout << distance << ' ' << paths[shape] << '\n';
  return EXIT_SUCCESS;
}
catch(const std::exception& e)
{
  std::cerr << e.what() << '\n';
  return EXIT_FAILURE;
}
