// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The registrars that several tests use.

#ifndef CGAL_CANONICAL_POSE_3_TEST_REGISTRAR_H
#define CGAL_CANONICAL_POSE_3_TEST_REGISTRAR_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

namespace Canonical_pose_test {

using Registrar
  = CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<CGAL::Canonical_pose_3::Conforming_body_3>;
using Svd_registrar = CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3<
  CGAL::Canonical_pose_3::Conforming_body_3, CGAL::Deformation_Eigen_closest_rotation_traits_3>;

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_REGISTRAR_H
