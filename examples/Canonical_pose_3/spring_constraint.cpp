// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The canonical pose with the two hands of the figure pulled together by a spring, stiff or soft.
// Usage: spring_constraint [prefix of the poses to write, as OFF]

#include <CGAL/Canonical_pose_3/Vertex_constraints_3.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Examples = Canonical_pose_examples;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The vertices of a hand, sorted by their distance from its tip. A hand is pulled by many springs,
// since a single spring would pull a spike out of it.
std::vector<Mesh::Vertex_index> hand(const Mesh& mesh, const Mesh::Vertex_index tip)
{
  std::map<double, Mesh::Vertex_index> by_distance;
  for(const auto v : mesh.vertices())
  {
    const double d = CGAL::squared_distance(mesh.point(v), mesh.point(tip));
    if(d < 0.2 * 0.2)
      by_distance[d] = v;
  }
  std::vector<Mesh::Vertex_index> result;
  for(const auto& entry : by_distance)
    result.push_back(entry.second);
  return result;
}

int main(int argc, char* argv[])
{
  const Examples::Articulated_figure figure(5000);
  const Mesh mesh = figure.make_mesh<Mesh>();
  const auto left = hand(mesh, Mesh::Vertex_index(figure.landmark(Examples::Landmark::LEFT_HAND)));
  const auto right
    = hand(mesh, Mesh::Vertex_index(figure.landmark(Examples::Landmark::RIGHT_HAND)));
  const std::size_t n = (std::min)(left.size(), right.size());

  CP::Result reused; // distances and target are the same for all three
  std::map<std::string, double> distance;
  for(const auto& [name, stiffness] :
      std::map<std::string, double>{{"none", 0}, {"soft", 0.02}, {"stiff", 1}})
  {
    CP::Options options;
    options.given = reused;
    options.return_landmark_fields = true;
    CP::Vertex_constraints_3<Mesh> constraints(mesh);
    for(std::size_t i = 0; i < n && stiffness > 0; ++i)
      constraints.add_spring(left[i], right[i], 0.1 /* meters */, stiffness / double(n));
    options.constraints = constraints.constraints();
    Mesh pose = mesh;
    reused = CGAL::canonical_pose_3(mesh, pose.points(), options);
    if(!reused.is_usable())
      return EXIT_FAILURE;
    const auto& points = pose.points();
    distance[name] = std::sqrt(CGAL::squared_distance(points[left[0]], points[right[0]]));
    std::cout << name << ": hands " << distance[name] << " m apart; " << reused << '\n';
    if(argc > 1 && !CGAL::IO::write_polygon_mesh(std::string(argv[1]) + name + ".off", pose))
      return EXIT_FAILURE;
  }
  const bool pulled = distance["stiff"] < distance["soft"] && distance["soft"] < distance["none"];
  return pulled ? EXIT_SUCCESS : EXIT_FAILURE;
}
