// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_VERTEX_MAP_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_VERTEX_MAP_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Vertices of an input; rows of distances and targets, which are the same, except for a complex,
// where they are vertices of its boundary, of which there may be more, since it is split where it is
// not manifold; components with a pose.
enum class Vertex_index : std::size_t {};
enum class Row_index : std::size_t {};
enum class Component_index : std::size_t { NONE = std::size_t(-1) };

// The vertex of the input of each vertex of a pose of a component.
inline Vertex_index vertex_of(const Surface_component_3& component, const std::size_t i)
{
  return Vertex_index(component.body_origins[i]);
}

// The row of each vertex of a component.
inline Row_index row_of(const Surface_component_3& component, const std::size_t i)
{
  return Row_index(component.origins[i]);
}

// Vertices with weights that decrease with the distance from what they touch: a sword moves with the
// hand, even if its tip is near a foot.
struct Rigid_part
{
  std::vector<Vertex_index> vertices;
  std::vector<double> weights;
};

// Maps the vertices of an input to those of its components and to their representatives.
struct Vertex_map
{
  // the vertex whose copies represent each vertex of the input: itself, unless it was stitched to
  // another one; the same for rows
  Indexed_vector<Vertex_index, Vertex_index> representatives;
  Indexed_vector<Row_index, Row_index> representative_rows;
  // the vertex of each row of distances and targets, and the name of such a row in messages
  Indexed_vector<Row_index, Vertex_index> vertex_of_row;
  const char* row_name = "vertex";

  // for each vertex of the input: its component (the largest one, if several) and its index in the
  // pose of this component
  Indexed_vector<Vertex_index, Component_index> component_of;
  Indexed_vector<Vertex_index, std::size_t> local_of;
  // for each row: the component on whose surface it is (the largest one, if several)
  Indexed_vector<Row_index, Component_index> component_of_row;
  // vertices of several components
  std::vector<Vertex_index> shared;
  // vertices without a component
  std::vector<Vertex_index> attached;
  // components without a pose that are moved rigidly
  std::vector<Rigid_part> rigid_parts;
  // vertices of components that keep their place
  std::vector<Vertex_index> fixed;
  // for each component: the indices of its followers, attached vertices before those of the options
  Indexed_vector<Component_index, std::vector<std::size_t>> followers_of;

  std::size_t number_of_vertices() const { return representatives.size(); }
  std::size_t number_of_rows() const { return vertex_of_row.size(); }

  std::string name_of_row(const Row_index row) const
  {
    return row_name + (' ' + std::to_string(static_cast<std::size_t>(row)));
  }
};

template <class Number>
void sort_and_make_unique(std::vector<Number>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_VERTEX_MAP_H
