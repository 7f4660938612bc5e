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
#include <CGAL/Canonical_pose_3/internal/pipeline/Factor_makers.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The linear solver that is given, or that the options request. Throws `std::runtime_error` if the program was built
// without it.
struct Solver : Factor_makers
{
  explicit Solver(const Options& options, const Factor_makers& given = Factor_makers())
    : Factor_makers(given)
  {
    if(factor_maker != nullptr)
      return;
#ifndef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
    if(options.solver == Options::Solver::CHOLMOD)
      throw std::runtime_error("the program was built without CHOLMOD");
#endif
    const bool is_eigen = options.solver == Options::Solver::EIGEN;
    factor_maker = is_eigen ? make_factor<Eigen_factor_traits_d> : make_default_factor;
    lane_factor_maker
      = is_eigen ? make_lane_factor<Eigen_factor_traits_d> : make_default_lane_factor;
  }
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SOLVER_H
