// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The pose applied to points near the surface: the vertices of a finer figure serve as markers on a
// coarse one.

#include <CGAL/Canonical_pose_3/surface_measures.h>
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
  const auto sitting = Articulated_figure::named_poses()[1].angles;
  const Mesh coarse = Articulated_figure(2500).make_mesh<Mesh>(sitting);
  const Articulated_figure fine_figure(10000);
  const Mesh fine = fine_figure.make_mesh<Mesh>(sitting);

  CP::Options options;
  options.followers = CP::point_matrix(fine);
  Mesh pose = coarse;
  const auto result = CGAL::canonical_pose_3(coarse, pose.points(), options);
  std::cout << result << '\n';
  if(!result.is_usable())
    return EXIT_FAILURE;

  Mesh fine_pose = fine;
  CP::put_points(result.pose_of_followers, fine, fine_pose.points(), Kernel());
  const double strain
    = CP::median_edge_strain(options.followers, result.pose_of_followers, fine_figure.triangles());
  std::cout << "median edge strain of the finer surface: " << strain << '\n';
  return strain < 0.1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
