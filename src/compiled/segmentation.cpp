// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/internal/segmentation/consensus_segmentation_impl.h>
#include <CGAL/Canonical_pose_3/internal/segmentation/k_means_segmentation_impl.h>
#include <CGAL/Canonical_pose_3/internal/segmentation/sweep_segmentation_impl.h>
