// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_REGISTRAR_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_REGISTRAR_H

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/internal/Body_view.h>

namespace Canonical_pose_benchmark {

/// The registrar of canonical_pose_3() with its default solver, of any body: src/poses.cpp compiles it.
using Registrar = CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::internal::Body_view, CGAL::Default,
  CGAL::Canonical_pose_3::Default_factor_traits_d>;

} // namespace Canonical_pose_benchmark

extern template class CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::internal::Body_view, CGAL::Default,
  CGAL::Canonical_pose_3::Default_factor_traits_d>;

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_REGISTRAR_H
