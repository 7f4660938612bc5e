// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closest_rotation.h"

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Rotation_routines default_rotation_routines() { return {closest_rotation, closest_rotations}; }

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
