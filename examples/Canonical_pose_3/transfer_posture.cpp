// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A figure takes the posture of another one, which has other vertices, and keeps its details.

#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <cstdlib>
#include <iostream>

namespace CP = CGAL::Canonical_pose_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Canonical_pose_examples::Articulated_figure;

int main()
{
  const auto running = Articulated_figure::named_poses()[1].angles;
  const auto sitting = Articulated_figure::named_poses()[2].angles;
  const Articulated_figure figure(2500), other_figure(3500);
  const Mesh mesh = figure.make_mesh<Mesh>(running), other = other_figure.make_mesh<Mesh>(sitting);
  Mesh pose = mesh, other_pose = other, result = mesh;
  if(!CGAL::canonical_pose_3(mesh, pose.points()).is_usable()
     || !CGAL::canonical_pose_3(other, other_pose.points()).is_usable())
    return EXIT_FAILURE;
  const CP::Surface_match_3 match
    = CP::match_surfaces(CP::Matchable_surface_3(mesh, pose.points()),
                         CP::Matchable_surface_3(other, other_pose.points()));

  // The target is where the vertices are on the other figure, in the size of this one.
  CP::Options options;
  options.given.target = match.scale * match.interpolated(CP::point_matrix(other));
  const CP::Result posed = CGAL::canonical_pose_3(mesh, result.points(), options);

  const double difference
    = CP::pose_difference(CP::point_matrix(result), CP::point_matrix(figure.make_mesh<Mesh>(sitting)));
  std::cout << "difference from the posture: " << difference << ", median strain "
            << posed.summary.median_edge_strain << ", inverted cells " << posed.summary.inverted
            << '\n';
  return posed.is_usable() && posed.summary.inverted == 0 && difference < 0.05 ? EXIT_SUCCESS
                                                                               : EXIT_FAILURE;
}
