// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Landmarks, distances and target of one call passed to others: for other options at no cost, and
// for a user-defined target.

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
  const Articulated_figure figure(2500);
  const auto named_poses = Articulated_figure::named_poses();
  const Mesh mesh = figure.make_mesh<Mesh>(named_poses[1].angles); // sitting
  Mesh pose = mesh;

  CP::Options options;
  options.return_landmark_fields = true;
  const auto first = CGAL::canonical_pose_3(mesh, pose.points(), options);
  std::cout << "detail length 0.1:  " << first << '\n'
            << "landmarks " << first.landmark_fields->landmarks.size() << ", largest distance "
            << first.landmark_fields->distances.maxCoeff() << '\n';

  options.given = first; // neither distances nor target are recomputed, not even in rounds
  options.registration.detail_length = 0.05; // the target is followed more closely
  const auto second = CGAL::canonical_pose_3(mesh, pose.points(), options);
  std::cout << "detail length 0.05: " << second << '\n';

  // A user-defined target: the standing figure. Distances are kept; the largest one is the unit of
  // length.
  options.registration.detail_length = 0.1;
  options.given.target = CP::point_matrix(figure.make_mesh<Mesh>(named_poses[0].angles));
  const auto third = CGAL::canonical_pose_3(mesh, pose.points(), options);
  std::cout << "own target:         " << third << '\n';

  return first.is_usable() && second.summary.energy_match < first.summary.energy_match
             && third.summary.target.kernel == "given"
           ? EXIT_SUCCESS
           : EXIT_FAILURE;
}
