// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The T-pose of a crouching figure, and its joints.

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
  const Articulated_figure figure(5000);
  Mesh mesh = figure.make_mesh<Mesh>(Articulated_figure::named_poses().back().angles);

  CP::Options options;
  options.stance = CP::Options::Stance::T;
  const CP::Result result = CGAL::canonical_pose_3(mesh, mesh.points(), options);
  if(!result.is_usable())
    return EXIT_FAILURE;

  // x is to the left of the figure, y upward, and z to the front.
  for(const CP::Skeleton_3::Joint& joint : result.skeleton->joints)
    std::cout << joint.name << " at " << joint.position << '\n';
  return result.skeleton->kind == CP::Skeleton_3::Kind::PERSON ? EXIT_SUCCESS : EXIT_FAILURE;
}
