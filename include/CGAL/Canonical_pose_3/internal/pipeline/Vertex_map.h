// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_VERTEX_MAP_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_VERTEX_MAP_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Maps the vertices of an input to those of its components and to their representatives.
struct Vertex_map
{
  static constexpr std::size_t NONE = std::size_t(-1);

  // for each vertex of the input: the one whose copies represent it, itself unless it was stitched
  // to another one
  std::vector<std::size_t> representatives;
  // the vertex of each row of distances and targets, and the name of such a row in messages
  std::vector<std::size_t> vertex_of_row;
  const char* row_name = "vertex";

  // for each vertex of the input: its component (the largest one, if several) and its row in the
  // pose of this component; or `NONE`
  std::vector<std::size_t> component_of, local_of;
  // vertices of several components
  std::vector<std::size_t> shared;
  // vertices without a component
  std::vector<std::size_t> attached;
  // vertices of components without a pose that do not touch a component with a pose: since they are
  // far from the cells that they follow, they are transformed rigidly, to avoid distortion
  std::vector<std::vector<std::size_t>> rigid_parts;
  // for each component: the indices of its followers, attached vertices before those of the options
  std::vector<std::vector<std::size_t>> followers_of;

  std::size_t number_of_rows() const { return vertex_of_row.size(); }

  std::string name_of_row(const std::size_t row) const
  {
    return row_name + (' ' + std::to_string(row));
  }
};

inline void sort_and_make_unique(std::vector<std::size_t>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_VERTEX_MAP_H
