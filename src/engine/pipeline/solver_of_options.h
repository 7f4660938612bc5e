// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_SOLVER_OF_OPTIONS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_SOLVER_OF_OPTIONS_H

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Linear_solver.h>
#include <CGAL/Canonical_pose_3/Options.h>

#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_SOLVER_OF_OPTIONS_H
