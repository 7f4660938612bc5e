// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/internal/target/Coarse_surface_3_impl.h>
#include <CGAL/Canonical_pose_3/internal/target/Smacof_target_builder_3_impl.h>
#include <CGAL/Canonical_pose_3/internal/target/align_target_impl.h>
#include <CGAL/Canonical_pose_3/internal/target/target_handedness_impl.h>
