// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The long part of canonical_pose_3(), compiled once for all programs here.

#define CGAL_CANONICAL_POSE_3_DEFINE_APART

#include <CGAL/Canonical_pose_3/internal/pose_of_complex.h>
#include <CGAL/Canonical_pose_3/internal/pose_of_surface.h>

// The registrar of the default solver as a whole, for programs that take the steps themselves.
template class CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::internal::Body_view, CGAL::Default,
  CGAL::Canonical_pose_3::Default_factor_traits_d>;
