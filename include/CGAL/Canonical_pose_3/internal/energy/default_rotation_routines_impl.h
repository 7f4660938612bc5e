// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_IMPL_H

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/energy/closest_rotation.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

CGAL_CANONICAL_POSE_3_INLINE Rotation_routines default_rotation_routines()
{
  return {closest_rotation, closest_rotations};
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_IMPL_H
