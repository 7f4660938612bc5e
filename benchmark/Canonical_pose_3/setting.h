// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_SETTING_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_SETTING_H

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <sstream>
#include <string>
#include <thread>

// set by the build
#ifndef CANONICAL_POSE_3_COMPILED_WITH
#define CANONICAL_POSE_3_COMPILED_WITH "compiler and flags not told"
#endif

namespace Canonical_pose_benchmark {

/// Describes in one line what the times depend on: compiler, flags, libraries, solver, threads.
inline std::string setting()
{
  const CGAL::Canonical_pose_3::Library_configuration library
    = CGAL::Canonical_pose_3::library_configuration();
  std::ostringstream out;
  out << CANONICAL_POSE_3_COMPILED_WITH << "; CGAL " << library.cgal << ", Eigen " << library.eigen
      << "; solver " << CGAL::Canonical_pose_3::Default_factor_traits_d::name() << "; "
      << std::thread::hardware_concurrency() << " cores, "
      << (library.tbb ? "TBB" : "no TBB");
  return out.str();
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_SETTING_H
