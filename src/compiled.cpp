// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Canonical_pose_3::compiled: what takes long to compile.

#define CGAL_CANONICAL_POSE_3_SOURCE

#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_complex.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_surface.h>
