// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors of the geodesic distances against shortest paths, on meshes as they are found.
//
// How to read: one line per mesh and method. Relative errors over all vertices and sources: mean and
// largest in percent, and the share of vertices that are wrong by more than 5 percent. `heat` is
// Heat_geodesics_3, `CGAL` CGAL's Heat_method_3 (Intrinsic_Delaunay), `wavefront`
// Wavefront_geodesics_3. Each mesh is repaired first, as in the one call; of several components the
// largest is taken.
//
// Usage: geodesic_errors_benchmark [--sources 2] mesh files

#include "Argument_list.h"
#include "setting.h"
#include "spread_sources.h"

#include "formats/Cgal_types.h" // of the tool
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Tool = Canonical_pose_tool;
using Canonical_pose_benchmark::Argument_list;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Heat_of_cgal
  = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh,
                                                           CGAL::Heat_method_3::Intrinsic_Delaunay>;

namespace {

Mesh read_mesh(const std::string& file)
{
  const Tool::Mesh_file input = Tool::read_mesh_file(file);
  const CP::Repaired_surface_3 surface
    = CP::repair_surface(Tool::matrix_of(Tool::points_of(input)), input.faces);
  const CP::Repaired_surface_3 largest = CP::component_of_surface(surface, 0);
  return CP::make_triangle_mesh<Mesh>(largest.points, largest.triangles);
}

Eigen::MatrixXd distances_of_cgal(Mesh mesh, const std::vector<Mesh::Vertex_index>& sources)
{
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
  Heat_of_cgal heat(mesh);
  Eigen::MatrixXd result(Eigen::Index(mesh.number_of_vertices()), Eigen::Index(sources.size()));
  for(std::size_t k = 0; k < sources.size(); ++k)
  {
    heat.clear_sources();
    heat.add_source(sources[k]);
    heat.estimate_geodesic_distances(distance);
    for(const Mesh::Vertex_index v : mesh.vertices())
      result(Eigen::Index(std::size_t(v)), Eigen::Index(k)) = distance[v];
  }
  return result;
}

void print_errors(const std::string& name, const char* const method,
                  const Eigen::MatrixXd& distances, const Eigen::MatrixXd& exact)
{
  double sum = 0, largest = 0;
  std::size_t number = 0, number_of_wrong = 0;
  for(Eigen::Index k = 0; k < exact.size(); ++k)
    if(exact(k) > 0)
    {
      const double error = std::abs(distances(k) - exact(k)) / exact(k);
      sum += error;
      largest = (std::max)(largest, error);
      number_of_wrong += error > 0.05;
      ++number;
    }
  std::printf("%-24s%9td %-10s%10.4g%10.3g%10.2f\n", name.c_str(), exact.rows(), method,
              100 * sum / double(number), 100 * largest,
              100 * double(number_of_wrong) / double(number));
  std::fflush(stdout);
}

void run(const std::string& file, const std::size_t number_of_sources)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  const Mesh mesh = read_mesh(file);
  const std::vector<Mesh::Vertex_index> sources
    = Canonical_pose_benchmark::spread_sources(mesh, number_of_sources);
  const Eigen::MatrixXd exact = CP::Exact_geodesics_3<Mesh>(mesh).distances(sources);
  print_errors(name, "heat", CP::Heat_geodesics_3<Mesh>(mesh).distances(sources), exact);
  print_errors(name, "CGAL", distances_of_cgal(mesh, sources), exact);
  print_errors(name, "wavefront", CP::Wavefront_geodesics_3<Mesh>(mesh).distances(sources), exact);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto sources
      = (std::max)(std::size_t(1), std::size_t(arguments.take_number("--sources", 2)));
    const std::vector<std::string> files = arguments.rest();
    std::printf("%s\n%zu sources per mesh\n%-24s%9s %-10s%10s%10s%10s\n",
                Canonical_pose_benchmark::setting().c_str(), sources, "errors in percent",
                "vertices", "", "mean", "largest", "above 5 %");
    for(const std::string& file : files)
      run(file, sources);
  }
  catch(const std::exception& e)
  {
    std::cerr << "geodesic_errors_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
