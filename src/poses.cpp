// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The long parts of the library, compiled once for all programs here.

#define CGAL_CANONICAL_POSE_3_DEFINE_APART

#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_complex.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_surface.h>
