// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/internal/pipeline/extrapolated_fields_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/body_of_surface_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/geodesic_distances_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/joined_result_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/landmark_fields_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/mds_target_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_complex_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/pose_of_surface_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/prepare_surface_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/refined_target_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/registered_pose_impl.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/unfolded_target_impl.h>
