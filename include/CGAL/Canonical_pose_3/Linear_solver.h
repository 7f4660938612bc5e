// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LINEAR_SOLVER_H
#define CGAL_CANONICAL_POSE_3_LINEAR_SOLVER_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>

#include <memory>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief stores the type of a linear solver, which can thus be chosen at run time.

\sa `Options::linear_solver`
*/
class Linear_solver
{
public:
  /// selects `Default_factor_traits_d`.
  Linear_solver() = default;

  /// selects the type of the argument, which is not copied.
  /// \tparam FactorTraits a model of `SparseLinearAlgebraWithBlockFactorTraits_d`
  template <
    class FactorTraits,
    std::enable_if_t<std::conjunction<std::negation<std::is_same<FactorTraits, Linear_solver>>,
                                      internal::Is_factor_traits<FactorTraits>>::value,
                     int> = 0>
  explicit Linear_solver(const FactorTraits&) : m_factor_maker(internal::make_factor<FactorTraits>)
  {}

  /// \cond SKIP_IN_MANUAL
  internal::Factor_maker factor_maker() const { return m_factor_maker; }
  /// \endcond

private:
  internal::Factor_maker m_factor_maker = internal::make_default_factor;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LINEAR_SOLVER_H
