// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The registrars that several tests use; registrar.cpp compiles their long parts, once for all tests.

#ifndef CGAL_CANONICAL_POSE_3_TEST_REGISTRAR_H
#define CGAL_CANONICAL_POSE_3_TEST_REGISTRAR_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

namespace Canonical_pose_test {

typedef CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3>
  Registrar;
typedef CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3, CGAL::Deformation_Eigen_closest_rotation_traits_3>
  Svd_registrar;

} // namespace Canonical_pose_test

extern template class CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3>;
extern template class CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3, CGAL::Deformation_Eigen_closest_rotation_traits_3>;

#endif // CGAL_CANONICAL_POSE_3_TEST_REGISTRAR_H
