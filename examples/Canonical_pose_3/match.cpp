// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which point of a figure is which point of another one, in another posture and with other vertices.

#include <CGAL/Canonical_pose_3/match_surfaces.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Location = PMP::Face_location<Mesh, Kernel::FT>;
using Canonical_pose_examples::Articulated_figure;

int main()
{
  const Articulated_figure figure(2500), other_figure(3500);
  Mesh mesh = figure.make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles);
  const Mesh other = other_figure.make_mesh<Mesh>(Articulated_figure::named_poses()[2].angles);

  const auto locations = mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const auto match = CGAL::Canonical_pose_3::match_surfaces(mesh, other, locations);

  // In their rest shapes, points that match have nearly the same height.
  const Mesh rest = figure.make_mesh<Mesh>(), rest_of_other = other_figure.make_mesh<Mesh>();
  double error = 0;
  for(const Mesh::Vertex_index v : vertices(mesh))
    error += std::abs(PMP::construct_point(locations[v], rest_of_other).y() - rest.point(v).y());
  error /= static_cast<double>(num_vertices(mesh));
  std::cout << "mean error of the height: " << error << ", of a figure of height 1.8\n"
            << "front and back " << (match.is_rotation_certain ? "are" : "may not be")
            << " where they should be\n";
  return error < 0.03 ? EXIT_SUCCESS : EXIT_FAILURE;
}
