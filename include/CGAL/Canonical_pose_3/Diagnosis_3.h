// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H
#define CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H

#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief lists what is found on a triangle soup or a triangle mesh before it is used.

\sa `diagnose()`
*/
struct Diagnosis_3
{
  /// number of vertices.
  std::size_t vertices = 0;
  /// number of faces.
  std::size_t faces = 0;
  /// number of vertices of no face.
  std::size_t isolated_vertices = 0;
  /// number of connected components of the faces (by common edges or vertices).
  std::size_t components = 0;
  /// number of edges of one face only.
  std::size_t boundary_edges = 0;
  /// number of edges of more than two faces, or of two faces that run through it in the same
  /// direction.
  std::size_t non_manifold_edges = 0;
  /// number of vertices whose faces form more than one fan.
  std::size_t non_manifold_vertices = 0;
  /// number of faces without area, those that name a vertex twice included.
  std::size_t degenerate_faces = 0;
  /// number of pairs of faces that intersect without being neighbours; empty where it was not
  /// computed: the faces are no 2-manifold, or degenerate.
  std::optional<std::size_t> self_intersections;
  /// one line that names the worst defect and an element that shows it; empty if there is none.
  /// Holes are a defect here.
  std::string first_defect;

  /// returns whether the surface is closed, 2-manifold, connected and free of degenerate and of
  /// intersecting faces.
  bool is_clean() const { return first_defect.empty(); }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H
