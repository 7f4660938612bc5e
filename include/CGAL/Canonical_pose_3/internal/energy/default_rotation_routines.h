// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_H

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_DEFAULT_ROTATION_ROUTINES_H
