// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_PRECONDITION_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_PRECONDITION_H

#include <CGAL/assertions.h>

// As CGAL_precondition, but also checked in optimized builds: the library is built once, for all programs.
#define CANONICAL_POSE_3_PRECONDITION(EX)                                                          \
  ((EX) ? static_cast<void>(0) : ::CGAL::precondition_fail(#EX, __FILE__, __LINE__))

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_PRECONDITION_H
