// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_EXAMINE_SURFACE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_EXAMINE_SURFACE_H

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

struct Examined_surface
{
  Diagnosis_3 diagnosis;
  Repaired_surface_3 surface;
};

// diagnose() and repair_surface() combined: their results, and their exceptions in this order.
Examined_surface examine_surface(const Point_matrix& points,
                                 const std::vector<std::vector<std::size_t>>& polygons);

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/soup/examine_surface_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SOUP_EXAMINE_SURFACE_H
