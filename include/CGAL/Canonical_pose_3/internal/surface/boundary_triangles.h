// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_BOUNDARY_TRIANGLES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_BOUNDARY_TRIANGLES_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
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
namespace internal {

// The faces of cells: face k of cell t has index 4 t + k.
class Cell_faces
{
public:
  explicit Cell_faces(const std::vector<std::array<int, 4>>& cells) : m_cells(cells)
  {
    m_faces.reserve(4 * cells.size());
    for(std::size_t f = 0; f < 4 * cells.size(); ++f)
    {
      std::array<int, 3> face;
      for(std::size_t k = 0; k < 3; ++k)
        face[k] = cells[f / 4][outward(f)[k]];
      std::sort(face.begin(), face.end());
      m_faces.emplace_back(face, f);
    }
    std::sort(m_faces.begin(), m_faces.end());
  }

  // Calls f(begin, end) for each face, with the range of its occurrences, pairs of vertices and
  // index.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    for(auto begin = m_faces.begin(); begin != m_faces.end();)
    {
      auto end = begin + 1;
      while(end != m_faces.end() && end->first == begin->first)
        ++end;
      f(begin, end);
      begin = end;
    }
  }

  // Returns the faces of exactly one cell, in the order of their indices. Faces of more than two
  // cells are an error unless allowed.
  std::vector<std::size_t> boundary(const bool are_branches_allowed = false) const
  {
    std::vector<std::size_t> result;
    for_each_face([&](const auto begin, const auto end) {
      if(end - begin > 2 && !are_branches_allowed)
        refuse_branch(begin, end);
      if(end - begin == 1)
        result.push_back(begin->second);
    });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Returns the vertices of a face, oriented outward.
  Index_triangle triangle(const Point_matrix& points, const std::size_t f) const
  {
    const std::array<int, 4>& c = m_cells[f / 4];
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.row(k) = points.row(c[k + 1]) - points.row(c[0]);
    Index_triangle result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = static_cast<std::size_t>(c[outward(f)[k]]);
    if(edges.determinant() < 0)
      std::swap(result[1], result[2]);
    return result;
  }

private:
  // The cells of a face are more than two, or one of them occurs twice.
  template <class Iterator>
  void refuse_branch(const Iterator begin, const Iterator end) const
  {
    const auto vertices = [&](const Iterator occurrence) {
      std::array<int, 4> cell = m_cells[occurrence->second / 4];
      std::sort(cell.begin(), cell.end());
      return cell;
    };
    for(auto i = begin; i != end; ++i)
      for(auto j = i + 1; j != end; ++j)
        if(vertices(i) == vertices(j))
          throw std::invalid_argument("cells " + std::to_string(i->second / 4) + " and "
                                      + std::to_string(j->second / 4)
                                      + " are the same: they have the same vertices");
    throw std::invalid_argument("more than two cells, cell " + std::to_string(begin->second / 4)
                                + " among them, share a face");
  }

  // The corners of a face of a positively oriented cell.
  static const std::array<std::size_t, 3>& outward(const std::size_t f)
  {
    static constexpr std::array<std::array<std::size_t, 3>, 4> corners
      = {{{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};
    return corners[f % 4];
  }

  const std::vector<std::array<int, 4>>& m_cells;
  std::vector<std::pair<std::array<int, 3>, std::size_t>> m_faces;
};

// Returns the faces that belong to exactly one cell, oriented outward, in the order of the cells.
inline std::vector<Index_triangle> boundary_triangles(const Point_matrix& points,
                                                      const std::vector<std::array<int, 4>>& cells,
                                                      const bool are_branches_allowed = false)
{
  const Cell_faces faces(cells);
  std::vector<Index_triangle> triangles;
  for(const std::size_t f : faces.boundary(are_branches_allowed))
    triangles.push_back(faces.triangle(points, f));
  return triangles;
}

// Splits non-manifold vertices and edges. On return, the triangles refer to rows of `origins`,
// which stores the vertex of the body that each row is a copy of; only vertices of triangles have
// rows.
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_BOUNDARY_TRIANGLES_H
