// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The canonical pose of the sitting figure, with stiff hands that have no target and follow the
// arms; a visitor reports the progress of the registration, and would stop it after a minute.

#include <CGAL/Canonical_pose_3/property_values.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace CP = CGAL::Canonical_pose_3;
namespace Examples = Canonical_pose_examples;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The largest change of an edge of the hands, |log(length in the pose / length)|.
template <class StiffnessMap, class PoseMap>
double strain_of_hands(const Mesh& mesh, const StiffnessMap& stiffness, const PoseMap& pose)
{
  double result = 0;
  for(const auto e : mesh.edges())
  {
    const auto p = mesh.vertex(e, 0), q = mesh.vertex(e, 1);
    if(stiffness[p] > 1 && stiffness[q] > 1)
      result = (std::max)(result,
                          std::abs(std::log(CGAL::squared_distance(pose[p], pose[q])
                                            / CGAL::squared_distance(mesh.point(p), mesh.point(q))))
                            / 2);
  }
  return result;
}

int main()
{
  const Examples::Articulated_figure figure(2500);
  Mesh mesh = figure.make_mesh<Mesh>(Examples::Articulated_figure::named_poses()[1].angles);
  auto weight = mesh.add_property_map<Mesh::Vertex_index, double>("v:weight", 1).first;
  auto stiffness = mesh.add_property_map<Mesh::Vertex_index, double>("v:stiffness", 1).first;
  for(const auto hand : {Examples::Landmark::LEFT_HAND, Examples::Landmark::RIGHT_HAND})
    for(const auto v : mesh.vertices())
      if(CGAL::squared_distance(mesh.point(v),
                                mesh.point(Mesh::Vertex_index(figure.landmark(hand))))
         < 0.15 * 0.15 /* meters */)
      {
        weight[v] = 0;
        stiffness[v] = 30;
      }

  auto pose = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:pose").first;
  std::cout << CGAL::canonical_pose_3(mesh, pose) << '\n';
  const double before = strain_of_hands(mesh, stiffness, pose);

  CP::Options options;
  options.matching_weights = CP::property_values(mesh.vertices(), weight);
  options.stiffness = CP::property_values(mesh.vertices(), stiffness);
  CGAL::Real_timer timer;
  timer.start();
  options.visitor = [&](const CP::Registration_progress& progress) {
    if(progress.iteration % 10 == 0)
      std::cout << "iteration " << progress.iteration << ": energy " << progress.energy
                << ", largest move " << progress.largest_move << " L\n";
    return timer.time() < 60; // seconds
  };
  const auto summary = CGAL::canonical_pose_3(mesh, pose, options).summary;
  const double after = strain_of_hands(mesh, stiffness, pose);
  std::cout << summary << "\nstrain of the hands: " << before << ", now " << after << '\n';
  return summary.is_usable() && after < before / 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
