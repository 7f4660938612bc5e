// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H
#define CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief lists the defects and properties of a polygon soup or a polygon mesh.

\sa `diagnose()`
\sa `repair_surface()`
*/
struct Diagnosis_3
{
  /// is a type of defect, with the first elements that have it.
  struct Defect
  {
    /// one of `not_finite` (coordinates), `wrong_indices` (these two exclude all others), `no_faces`, `degenerate_faces`, `duplicate_faces`, `non_manifold_edges` (with more
    /// than two faces), `inconsistent_orientation`, `non_manifold_vertices`, `components`,
    /// `isolated_vertices`, `self_intersections`, `holes`, `inside_out`, `duplicated_points`,
    /// `polygons`; the worst come first.
    std::string kind;
    /// number of elements.
    std::size_t count;
    /// the type of an example: `vertex`, `face`, `edge` (its two vertices), `faces` (two of them)
    /// or `vertices` (two at the same position). The example of a component is its first face, that
    /// of a hole is one of its edges.
    std::string element;
    /// the first few of the elements, or all, as indices of vertices or faces.
    std::vector<std::vector<std::size_t>> examples;
    /// one line that states the defect and an element that has it.
    std::string message;
  };

  /// If the number of pairs of intersecting faces reaches this, the search ends.
  static constexpr std::size_t MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS = 100000;

  /// number of vertices.
  std::size_t vertices = 0;
  /// number of faces.
  std::size_t faces = 0;
  /// number of faces with more than three corners.
  std::size_t polygons = 0;
  /// number of isolated vertices.
  std::size_t isolated_vertices = 0;
  /// number of vertices at the position of an earlier one.
  std::size_t duplicated_points = 0;
  /// number of connected components of the faces (connected by common edges or vertices).
  std::size_t components = 0;
  /// number of components that are closed and oriented, and enclose a negative volume.
  std::size_t inside_out_components = 0;
  /// number of edges with only one face.
  std::size_t boundary_edges = 0;
  /// number of connected parts of the boundary edges.
  std::size_t holes = 0;
  /// number of edges with more than two faces, or with two faces that traverse the edge in the same
  /// direction.
  std::size_t non_manifold_edges = 0;
  /// number of edges with two faces that traverse the edge in the same direction.
  std::size_t inconsistently_oriented_edges = 0;
  /// number of vertices whose faces form more than one fan.
  std::size_t non_manifold_vertices = 0;
  /// number of faces without area, including those in which a vertex occurs twice.
  std::size_t degenerate_faces = 0;
  /// number of faces with the same vertices as an earlier one, in any order.
  std::size_t duplicate_faces = 0;
  /// number of pairs of faces that intersect without being neighbors, at most
  /// `MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS`. Degenerate and duplicate faces are ignored. Empty if
  /// there was no search, or if it was abandoned: there is no face, or the bounding boxes of far too
  /// many faces overlap.
  std::optional<std::size_t> self_intersections;
  /// whether there was a search for them. `diagnose()` does; for `CGAL::canonical_pose_3()`, see
  /// `Method_options::searches_self_intersections`.
  bool has_searched_self_intersections = false;
  /// the defects, the worst first.
  std::vector<Defect> defects;
  /// message of the first defect; empty if there is none. Holes count as a defect here.
  std::string first_defect;

  /// returns whether the surface is closed, 2-manifold, oriented and connected, without degenerate
  /// or intersecting faces. It may nevertheless have polygons and be inside out.
  bool is_clean() const
  {
    return faces > 0 && components == 1 && isolated_vertices == 0 && boundary_edges == 0
           && non_manifold_edges == 0 && non_manifold_vertices == 0 && degenerate_faces == 0
           && duplicate_faces == 0 && self_intersections == std::size_t(0);
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DIAGNOSIS_3_H
