// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_SPLIT_SURFACE_H
#define CGAL_CANONICAL_POSE_3_TOOL_SPLIT_SURFACE_H

#include "Shown_surface.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace Canonical_pose_tool {

// Of a vertex, for corners that differ.
struct Vertex_copy
{
  std::size_t vertex;
  long long part = -1; // -1 if there are no parts, or if it belongs to no face
  std::array<float, 2> texture_coordinates = {};
  std::array<float, 3> normal = {};

  bool operator<(const Vertex_copy& other) const
  {
    return std::tie(vertex, part, texture_coordinates, normal)
           < std::tie(other.vertex, other.part, other.texture_coordinates, other.normal);
  }
  bool operator==(const Vertex_copy& other) const { return !(*this < other) && !(other < *this); }
};

// The triangles of a surface; its vertices are split where parts meet, at hard edges, and at seams of the texture; sorted by vertex.
// Each has at least one copy.
struct Split_surface
{
  Split_surface(const CGAL::Canonical_pose_3::Point_matrix& points, const Shown_surface& surface);

  std::vector<Vertex_copy> copies;
  std::vector<std::array<std::size_t, 3>> triangles; // of copies
  std::vector<std::array<std::size_t, 3>> faces;     // the same of vertices
  std::vector<std::size_t> polygon_of_triangle;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_SPLIT_SURFACE_H
