// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_WITH_SOLVER_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_WITH_SOLVER_H

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/configuration.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Calls f with an object of the factor traits that the options name, on no more threads than they
// allow.
template <typename Function>
auto with_solver(const Options& options, const Function& f)
{
  if(options.number_of_threads < 0)
    throw std::invalid_argument("option number_of_threads is "
                                + std::to_string(options.number_of_threads) + ", but must be >= 0");
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> limit;
  if(options.number_of_threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(options.number_of_threads));
#endif
  switch(options.solver)
  {
  case Options::Solver::EIGEN:
    return f(Eigen_factor_traits_d());
  case Options::Solver::CHOLMOD:
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
    return f(Cholmod_factor_traits_d());
#else
    throw std::runtime_error("the program was built without CHOLMOD");
#endif
  default:
    return f(Default_factor_traits_d());
  }
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_WITH_SOLVER_H
