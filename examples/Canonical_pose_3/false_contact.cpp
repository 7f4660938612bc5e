// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How much a false contact, a hand that was merged with a knee, changes the pose: with a target,
// without a target (unfolding), and if the contact is cut.

#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>

#include "Articulated_figure.h"

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_figure;
using Point = CGAL::Simple_cartesian<double>::Point_3;

int main()
{
  const Articulated_figure figure(3000);
  std::vector<Point> points, pose;
  for(const auto& p : figure.points(Articulated_figure::hand_on_knee()))
    points.emplace_back(p[0], p[1], p[2]);

  // The merged figure has a few isolated vertices inside the contact; they follow the body.
  const auto effect_of_contact = [&](const CP::Options& options) {
    const CP::Result apart = CGAL::canonical_pose_3(points, figure.triangles(), pose, options);
    const CP::Result merged
      = CGAL::canonical_pose_3(points, figure.merged_triangles(), pose, options);
    for(const std::string& warning : merged.summary.warnings)
      std::cout << warning << '\n';
    return CP::pose_difference(apart.pose, merged.pose);
  };
  CP::Options options;
  const double with_target = effect_of_contact(options);
  options.target_mode = CP::Options::Target_mode::UNFOLDING;
  const double unfolded = effect_of_contact(options);
  options = CP::Options();
  options.contacts = CP::Options::Contacts::CUT;
  const double cut = effect_of_contact(options);
  std::cout << "difference of the poses with and without contact: " << with_target
            << "; unfolding: " << unfolded << "; contact cut: " << cut << '\n';
  return cut < with_target / 3 ? EXIT_SUCCESS : EXIT_FAILURE;
}
