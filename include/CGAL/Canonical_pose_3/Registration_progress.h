// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_REGISTRATION_PROGRESS_H
#define CGAL_CANONICAL_POSE_3_REGISTRATION_PROGRESS_H

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is passed to a `RegistrationVisitor_3` after each iteration. All members are dimensionless. The
last two tell where in the one call it is, and are 0 in calls of a registrar.
*/
struct Registration_progress
{
  /// number of completed iterations, from 1.
  int iteration;
  /// the energy \f$ E \f$, the sum of the next three.
  double energy;
  /// its matching term, or its unfolding term.
  double energy_match;
  /// its as-rigid-as-possible term.
  double energy_arap;
  /// the terms of the constraints.
  double energy_constraints;
  /// the largest displacement of a surface vertex in this iteration, divided by \f$ L \f$.
  double largest_move;
  /// the round, from 1, if the pose is one on which distances are measured; 0: it is the final one.
  int round = 0;
  /// the number of the component, from 0, by decreasing size. The smallest is posed first.
  std::size_t component = 0;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds any model of `RegistrationVisitor_3`, for instance a lambda expression, or none.
*/
using Registration_visitor = std::function<bool(const Registration_progress&)>;

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REGISTRATION_PROGRESS_H
