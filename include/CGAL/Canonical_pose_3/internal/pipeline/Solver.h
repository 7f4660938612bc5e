// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_H

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The linear solver that the options ask for. Throws `std::runtime_error` if the program was built without it.
struct Solver
{
  explicit Solver(const Options& options)
  {
    if(options.solver == Options::Solver::EIGEN)
    {
      factor_maker = make_factor<Eigen_factor_traits_d>;
      lane_factor_maker = make_lane_factor<Eigen_factor_traits_d>;
    }
#ifndef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
    if(options.solver == Options::Solver::CHOLMOD)
      throw std::runtime_error("the program was built without CHOLMOD");
#endif
  }

  Factor_maker factor_maker = make_default_factor;
  Lane_factor_maker lane_factor_maker = make_default_lane_factor;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_H
