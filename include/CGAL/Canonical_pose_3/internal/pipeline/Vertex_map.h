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

// Which vertices of an input are those of its components, and how they stand for one another.
struct Vertex_map
{
  static constexpr std::size_t NONE = std::size_t(-1);

  // of each vertex of the input: the one whose copies stand for it, itself unless it was sewn to that
  std::vector<std::size_t> representatives;
  // the vertex of each row of distances and targets, and what messages call such a row
  std::vector<std::size_t> vertex_of_row;
  const char* row_name = "vertex";

  // of each vertex of the input: its component, the largest of several, and its row in the pose of that; or `NONE`
  std::vector<std::size_t> component_of, local_of;
  // vertices of several components
  std::vector<std::size_t> shared;
  // vertices without component
  std::vector<std::size_t> attached;
  // vertices of components without a pose that do not touch one with a pose: far from the cells that they follow, these
  // say how they are moved and turned, but would distort them
  std::vector<std::vector<std::size_t>> rigid_parts;
  // of each component: the indices of its followers, attached vertices coming before those of the options
  std::vector<std::vector<Eigen::Index>> followers_of;

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
