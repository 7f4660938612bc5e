// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

void CGAL_CANONICAL_POSE_3_ALIGNMENT() {}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
