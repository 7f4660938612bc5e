// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/internal/soup/cut_contacts_impl.h>
#include <CGAL/Canonical_pose_3/internal/soup/diagnose_impl.h>
#include <CGAL/Canonical_pose_3/internal/soup/examine_surface_impl.h>
#include <CGAL/Canonical_pose_3/internal/soup/repair_surface_impl.h>
