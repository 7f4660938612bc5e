// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_TAKE_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_TAKE_OPTIONS_H

#include <CGAL/Canonical_pose_3/Options.h>

#include "Argument_list.h"

#include "exact_geodesics.h" // of the tool

#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

/// Reads and removes --geodesics, --body, --components and --rounds.
inline CGAL::Canonical_pose_3::Options take_options(Argument_list& list)
{
  using Options = CGAL::Canonical_pose_3::Options;
  Options options;
  const std::vector<std::string> geodesics = {"heat", "wavefront", "exact"};
  Canonical_pose_tool::set_geodesics(options, geodesics[list.take_choice("--geodesics", geodesics)]);
  options.body
    = static_cast<Options::Body>(list.take_choice("--body", {"auto", "lattice", "tetgen", "mesh"}));
  options.components = static_cast<Options::Components>(
    list.take_choice("--components", {"auto", "refuse", "largest", "each"}));
  const double rounds = list.take_number("--rounds", -1);
  if(rounds >= 0)
    options.number_of_rounds = static_cast<int>(rounds);
  return options;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_TAKE_OPTIONS_H
