// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_OF_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_OF_OPTIONS_H

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Linear_solver.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The requested linear solver. Throws `std::runtime_error` if the program was built without it.
inline Linear_solver solver_of_options(const Method_options& options)
{
  if(options.linear_solver)
    return *options.linear_solver;
#ifndef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  if(options.solver == Options::Solver::CHOLMOD)
    throw std::runtime_error("the program was built without CHOLMOD");
#endif
  if(options.solver == Options::Solver::EIGEN)
    return Linear_solver(Eigen_factor_traits_d());
  return Linear_solver();
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_OF_OPTIONS_H
