// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Geodesic distances from one vertex, from several at once, and to the nearest of several.
// Usage: geodesics [input.off]

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    mesh = Canonical_pose_examples::Articulated_figure(2500).make_mesh<Mesh>();
  else if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;

  const CP::Heat_geodesics_3<Mesh> geodesics(mesh); // factors both systems, once

  // One source; distances to a property map.
  const Mesh::Vertex_index source = *mesh.vertices().begin();
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  geodesics.distances(source, distance);
  Mesh::Vertex_index farthest = source;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(distance[v] > distance[farthest])
      farthest = v;
  std::cout << "vertex " << std::size_t(farthest) << " is farthest from vertex "
            << std::size_t(source) << ": " << distance[farthest] << '\n';

  // Several sources; a column of distances for each.
  const Eigen::MatrixXd distances
    = geodesics.distances(std::vector<Mesh::Vertex_index>{source, farthest});
  const double there = distances(geodesics.index(farthest), 0);
  const double back = distances(geodesics.index(source), 1);
  std::cout << "there " << there << ", back " << back
            << " (symmetric up to the error of the method)\n";
  std::cout << "same as one by one: " << (there == distance[farthest] ? "yes" : "no") << '\n';
  const bool is_near = std::abs(there - back) < 0.1 * there;

  // The nearest of several sources; and by another model, which factors nothing and is accurate to
  // a few hundredths of a percent.
  const CP::Wavefront_geodesics_3<Mesh> wavefront(mesh);
  const std::vector<Mesh::Vertex_index> both = {source, farthest};
  const double heat_radius = geodesics.distance_to_nearest(both).maxCoeff();
  const double radius = wavefront.distance_to_nearest(both).maxCoeff();
  std::cout << "no vertex is farther from the nearer one of both than " << radius
            << " (heat method: " << heat_radius << ")\n";
  const bool agrees = std::abs(radius - heat_radius) < 0.1 * radius;
  return is_near && agrees && there == distance[farthest] ? EXIT_SUCCESS : EXIT_FAILURE;
}
