// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_INLINE_DEFINITION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_INLINE_DEFINITION_H

// Functions that may be compiled apart are inline, except in the source that defines them for others; see
// poses.h.
#ifdef CGAL_CANONICAL_POSE_3_DEFINE_APART
#define CGAL_CANONICAL_POSE_3_DEFINITION
#else
#define CGAL_CANONICAL_POSE_3_DEFINITION inline
#endif

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_INLINE_DEFINITION_H
