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

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief lists what is found on a polygon soup or a polygon mesh before it is used.

\sa `diagnose()`
\sa `repair_surface()`
*/
struct Diagnosis_3
{
  /// is one kind of defect, with the first elements that show it.
  struct Defect
  {
    /// one of `no_faces`, `degenerate_faces`, `duplicate_faces`, `non_manifold_edges` (of more than
    /// two faces), `inconsistent_orientation`, `non_manifold_vertices`, `components`,
    /// `isolated_vertices`, `self_intersections`, `holes`, `inside_out`, `duplicated_points`,
    /// `polygons`; the worst come first.
    std::string kind;
    /// number of the elements.
    std::size_t count;
    /// what an example is: `vertex`, `face`, `edge` (its two vertices), `faces` (two of them) or
    /// `vertices` (two at the same place). One of a component is its first face, one of a hole an
    /// edge of it.
    std::string element;
    /// the first few of them, or all, as numbers of vertices or faces.
    std::vector<std::vector<std::size_t>> examples;
    /// one line that names the defect and an element that shows it.
    std::string message;
  };

  /// Where the number of pairs of faces that intersect reaches this, the search for more ends.
  static constexpr std::size_t MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS = 100000;

  /// number of vertices.
  std::size_t vertices = 0;
  /// number of faces.
  std::size_t faces = 0;
  /// number of faces of more than three corners.
  std::size_t polygons = 0;
  /// number of vertices of no face.
  std::size_t isolated_vertices = 0;
  /// number of vertices at the place of one before them.
  std::size_t duplicated_points = 0;
  /// number of connected components of the faces (by common edges or vertices).
  std::size_t components = 0;
  /// number of components that are closed, oriented, and enclose a negative volume.
  std::size_t inside_out_components = 0;
  /// number of edges of one face only.
  std::size_t boundary_edges = 0;
  /// number of connected parts of the boundary edges.
  std::size_t holes = 0;
  /// number of edges of more than two faces, or of two faces that run through it in the same
  /// direction.
  std::size_t non_manifold_edges = 0;
  /// the latter of them.
  std::size_t inconsistently_oriented_edges = 0;
  /// number of vertices whose faces form more than one fan.
  std::size_t non_manifold_vertices = 0;
  /// number of faces without area, those that name a vertex twice included.
  std::size_t degenerate_faces = 0;
  /// number of faces with the same vertices as one before them, in whatever order.
  std::size_t duplicate_faces = 0;
  /// number of pairs of faces that intersect without being neighbors, at most
  /// `MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS`. Degenerate and duplicate faces are left out. Empty where
  /// the search was given up: there is no face, or the bounding boxes of far too many faces overlap.
  std::optional<std::size_t> self_intersections;
  /// what was found, the worst first.
  std::vector<Defect> defects;
  /// message of the first defect; empty if there is none. Holes are a defect here.
  std::string first_defect;

  /// returns whether the surface is closed, 2-manifold, oriented, connected and free of degenerate
  /// and of intersecting faces. It may have polygons and be inside out nevertheless.
  bool is_clean() const
  {
    return faces > 0 && components == 1 && isolated_vertices == 0 && boundary_edges == 0
           && non_manifold_edges == 0 && non_manifold_vertices == 0 && degenerate_faces == 0
           && duplicate_faces == 0 && self_intersections == std::size_t(0);
  }
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H
