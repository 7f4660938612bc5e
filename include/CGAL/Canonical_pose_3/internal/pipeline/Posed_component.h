// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSED_COMPONENT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSED_COMPONENT_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// A part of the input that gets a pose of its own: its surface, connected, and what its vertices are in
// the input.
struct Posed_component
{
  Point_matrix points;
  std::vector<Index_triangle> triangles, caps;
  // the face of the input that each triangle is part of
  std::vector<std::size_t> faces;
  // the row in fields and targets of each vertex of the surface
  std::vector<std::size_t> field_rows;
  // the vertex of the input that each row of the pose is
  std::vector<std::size_t> vertices;
};

// What options say of the vertices of one component, in its rows.
struct Component_values
{
  Eigen::VectorXd matching_weights;
  Eigen::VectorXd stiffness; // of the vertices of a surface
  std::vector<Spring_3> springs;
  std::vector<Directed_pair_3> directions;
  std::vector<Handle_3> handles;
  std::vector<Symmetric_pair_3> symmetric_pairs;
  Point_matrix followers;
  Intermediate_results given;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSED_COMPONENT_H
