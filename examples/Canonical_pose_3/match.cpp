// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which point of a figure is which point of another one, in another posture and with other vertices.

#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace CP = CGAL::Canonical_pose_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Canonical_pose_examples::Articulated_figure;

CP::Matchable_surface_3 prepared(const Articulated_figure& figure, const int posture)
{
  const Mesh mesh = figure.make_mesh<Mesh>(Articulated_figure::named_poses()[posture].angles);
  Mesh pose = mesh;
  const CP::Result result = CGAL::canonical_pose_3(mesh, pose.points());
  if(!result.is_usable())
    throw std::runtime_error("there is no pose");
  return {mesh, pose.points()};
}

int main()
{
  const Articulated_figure one(2500), other(3500);
  const CP::Surface_match_3 match = CP::match_surfaces(prepared(one, 1), prepared(other, 2));

  // Any values of the other figure are carried over, here the heights in its rest shape.
  const CP::Point_matrix rest = CP::point_matrix(one.make_mesh<Mesh>()),
                         rest_of_other = CP::point_matrix(other.make_mesh<Mesh>());
  const double error = (match.interpolated(rest_of_other) - rest).col(1).cwiseAbs().mean()
                       / (rest.col(1).maxCoeff() - rest.col(1).minCoeff());
  std::cout << "mean error of the height: " << 100 * error << " %\n"
            << "front and back " << (match.is_rotation_certain ? "are" : "may not be")
            << " where they should be\n";
  return error < 0.02 ? EXIT_SUCCESS : EXIT_FAILURE;
}
