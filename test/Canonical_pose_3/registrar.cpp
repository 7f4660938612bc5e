// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include "registrar.h"

template class CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3>;
template class CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3, CGAL::Deformation_Eigen_closest_rotation_traits_3>;
