// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "interruption_check.h"

#include <CGAL/Canonical_pose_3/set_interruption_check.h>

namespace CGAL {
namespace Canonical_pose_3 {

void set_interruption_check(void (*const check)()) { internal::interruption_check = check; }

} // namespace Canonical_pose_3
} // namespace CGAL
