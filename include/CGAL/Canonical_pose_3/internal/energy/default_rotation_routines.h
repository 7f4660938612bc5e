// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_H

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// In closed form.
Rotation_routines default_rotation_routines();

// `ClosestRotationTraits`: a model of `DeformationClosestRotationTraits_3`, or `Default`.
template <class ClosestRotationTraits>
Rotation_routines rotation_routines()
{
  if constexpr(std::is_same<ClosestRotationTraits, Default>::value)
    return default_rotation_routines();
  else
    return {rotation_by_traits<ClosestRotationTraits>, rotations_by_traits<ClosestRotationTraits>};
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_H
