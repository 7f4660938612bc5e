// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_BOUNDARY_TRIANGLES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_BOUNDARY_TRIANGLES_H

#include <CGAL/Canonical_pose_3/internal/configuration.h>
#include <CGAL/Canonical_pose_3/internal/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The faces that belong to one cell only, oriented outwards, in the order of the cells. Faces of more
// than two are an error unless they are allowed.
inline std::vector<Index_triangle> boundary_triangles(const Point_matrix& points,
                                                      const std::vector<std::array<int, 4>>& cells,
                                                      const bool are_branches_allowed = false)
{
  static const int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::vector<std::pair<std::array<int, 3>, std::size_t>> faces;
  faces.reserve(4 * cells.size());
  for(std::size_t t = 0; t < cells.size(); ++t)
    for(int k = 0; k < 4; ++k)
    {
      std::array<int, 3> face
        = {cells[t][outward[k][0]], cells[t][outward[k][1]], cells[t][outward[k][2]]};
      std::sort(face.begin(), face.end());
      faces.emplace_back(face, 4 * t + k);
    }
  std::sort(faces.begin(), faces.end());

  std::vector<std::size_t> boundary;
  for(std::size_t i = 0; i < faces.size();)
  {
    std::size_t j = i + 1;
    while(j < faces.size() && faces[j].first == faces[i].first)
      ++j;
    if(j - i > 2 && !are_branches_allowed)
      throw std::invalid_argument("more than two cells, cell " + std::to_string(faces[i].second / 4)
                                  + " among them, share a face");
    if(j - i == 1)
      boundary.push_back(faces[i].second);
    i = j;
  }
  std::sort(boundary.begin(), boundary.end());

  std::vector<Index_triangle> triangles;
  for(const std::size_t f : boundary)
  {
    const std::array<int, 4>& c = cells[f / 4];
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.row(k) = points.row(c[k + 1]) - points.row(c[0]);
    const int* o = outward[f % 4];
    Index_triangle triangle = {std::size_t(c[o[0]]), std::size_t(c[o[1]]), std::size_t(c[o[2]])};
    if(edges.determinant() < 0)
      std::swap(triangle[1], triangle[2]);
    triangles.push_back(triangle);
  }
  return triangles;
}

// Splits vertices and edges at which the triangles are not a surface. On return the triangles name
// rows of `origins`, which tells the vertex of the body that each row is a copy of; only vertices
// of triangles have rows.
inline void make_boundary_manifold(std::vector<Index_triangle>& triangles,
                                   std::vector<std::size_t>& origins)
{
  origins.clear();
  for(const Index_triangle& t : triangles)
    origins.insert(origins.end(), t.begin(), t.end());
  std::sort(origins.begin(), origins.end());
  origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
  for(Index_triangle& t : triangles)
    for(std::size_t& v : t)
      v = static_cast<std::size_t>(std::lower_bound(origins.begin(), origins.end(), v)
                                   - origins.begin());
  std::vector<std::vector<std::size_t>> soup(triangles.size());
  for(std::size_t f = 0; f < triangles.size(); ++f)
    soup[f].assign(triangles[f].begin(), triangles[f].end());
  Polygon_mesh_processing::orient_polygon_soup(origins, soup);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    std::copy(soup[f].begin(), soup[f].end(), triangles[f].begin());
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_BOUNDARY_TRIANGLES_H
