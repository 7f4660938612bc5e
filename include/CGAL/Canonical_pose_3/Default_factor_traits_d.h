// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_DEFAULT_FACTOR_TRAITS_D_H
#define CGAL_CANONICAL_POSE_3_DEFAULT_FACTOR_TRAITS_D_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <CGAL/Canonical_pose_3/Cholmod_factor_traits_d.h>
#else
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#endif

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is the default solver: `Cholmod_factor_traits_d` if the macro
`CGAL_CANONICAL_POSE_3_USE_CHOLMOD` is defined, `Eigen_factor_traits_d` otherwise.

\cgalModels `SparseLinearAlgebraWithBlockFactorTraits_d`
*/
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
using Default_factor_traits_d = Cholmod_factor_traits_d;
#else
using Default_factor_traits_d = Eigen_factor_traits_d;
#endif

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DEFAULT_FACTOR_TRAITS_D_H
