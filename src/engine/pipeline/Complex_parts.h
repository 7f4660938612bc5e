// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_COMPLEX_PARTS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_COMPLEX_PARTS_H

#include "fragments.h"
#include "../surface/signed_volume.h"

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/surface/boundary_triangles.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A part of a complex: cells connected by common faces. Its surface is the outer one; the surfaces
// of its cavities have no target and follow the cells.
struct Complex_part
{
  std::vector<std::size_t> cells;
  std::vector<std::size_t> surface_vertices; // row in the pose of each vertex of the surface
  Surface_component_3 surface; // its body_origins are the vertices of the cells, in order
};

// The boundary of a complex, and its parts by decreasing volume. A part that has common vertices,
// but no common face, with a much larger one is merged with it: meshers may leave such fragments at
// edges.
class Complex_parts
{
public:
  // `volumes`: of the cells. Throws `std::invalid_argument` if more than two cells share a face, or
  // there is no boundary.
  Complex_parts(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                const Eigen::VectorXd& volumes)
    : m_points(points), m_cells(cells), m_volumes(volumes), m_faces(cells),
      m_boundary_faces(m_faces.boundary())
  {
    if(m_boundary_faces.empty())
      throw std::invalid_argument("the complex has no boundary");
    for(const std::size_t f : m_boundary_faces)
      m_triangles.push_back(m_faces.triangle(points, f));
    make_boundary_manifold(m_triangles, m_boundary_vertices);
    m_boundary_points = rows_at(points, m_boundary_vertices);
    find_parts();
  }

  const Point_matrix& boundary_points() const { return m_boundary_points; }
  const std::vector<Index_triangle>& boundary_triangles() const { return m_triangles; }
  // The vertex of the complex for each vertex of the boundary.
  const std::vector<std::size_t>& boundary_vertices() const { return m_boundary_vertices; }

  std::size_t size() const { return m_cells_of_parts.size(); }

  Complex_part operator[](const std::size_t i) const
  {
    Complex_part part;
    part.cells = m_cells_of_parts[i];
    part.surface = surface_of(m_outer_surfaces[i]);
    for(const std::size_t t : part.cells)
      for(const int v : m_cells[t])
        part.surface.body_origins.push_back(static_cast<std::size_t>(v));
    sort_and_make_unique(part.surface.body_origins);
    for(const std::size_t row : part.surface.origins)
      part.surface_vertices.push_back(
        index_in(part.surface.body_origins, m_boundary_vertices[row]));
    return part;
  }

  // The cells of a part, as rows of its pose.
  std::vector<std::array<int, 4>> local_cells(const Complex_part& part) const
  {
    std::vector<std::array<int, 4>> result;
    for(const std::size_t t : part.cells)
    {
      result.emplace_back();
      for(std::size_t k = 0; k < 4; ++k)
        result.back()[k] = static_cast<int>(
          index_in(part.surface.body_origins, static_cast<std::size_t>(m_cells[t][k])));
    }
    return result;
  }

private:
  static std::size_t index_in(const std::vector<std::size_t>& sorted, const std::size_t number)
  {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), number)
                                    - sorted.begin());
  }

  // The items with each label.
  static std::vector<std::vector<std::size_t>> items_of_labels(const Component_labels& labels)
  {
    std::vector<std::vector<std::size_t>> result(labels.first_items.size());
    for(std::size_t i = 0; i < labels.of_items.size(); ++i)
      result[labels.of_items[i]].push_back(i);
    return result;
  }

  double volume(const std::vector<std::size_t>& cells) const
  {
    return std::accumulate(cells.begin(), cells.end(), 0., [&](const double sum, std::size_t t) {
      return sum + m_volumes[static_cast<Eigen::Index>(t)];
    });
  }

  void find_parts()
  {
    Disjoint_sets sets(m_cells.size());
    m_faces.for_each_face([&](const auto begin, const auto end) {
      if(end - begin == 2)
        sets.unite(begin->second / 4, (begin + 1)->second / 4);
    });
    std::vector<std::vector<std::size_t>> parts = items_of_labels(label_components(sets));
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const auto& a, const auto& b) { return volume(a) > volume(b); });
    find_outer_surfaces(parts);
    unite_fragments(parts);
  }

  // Of the surfaces of a part, the outer one is that with the largest volume.
  void find_outer_surfaces(const std::vector<std::vector<std::size_t>>& parts)
  {
    std::vector<std::size_t> part_of_cell(m_cells.size());
    for(std::size_t p = 0; p < parts.size(); ++p)
      for(const std::size_t t : parts[p])
        part_of_cell[t] = p;
    Disjoint_sets vertices(m_boundary_vertices.size());
    for(const Index_triangle& t : m_triangles)
    {
      vertices.unite(t[0], t[1]);
      vertices.unite(t[0], t[2]);
    }
    const auto corner = [&](const std::size_t i) { return m_triangles[i][0]; };
    const Component_labels surfaces = label_components(vertices, m_triangles.size(), corner);
    m_outer_surfaces.resize(parts.size());
    std::vector<double> largest(parts.size(), -std::numeric_limits<double>::infinity());
    for(std::vector<std::size_t>& surface : items_of_labels(surfaces))
    {
      const Surface_component_3 component = surface_of(surface);
      const double volume = signed_volume(component.points, component.triangles);
      const std::size_t p = part_of_cell[m_boundary_faces[surface.front()] / 4];
      if(volume > largest[p])
      {
        largest[p] = volume;
        m_outer_surfaces[p] = std::move(surface);
      }
    }
  }

  void unite_fragments(const std::vector<std::vector<std::size_t>>& parts)
  {
    std::vector<double> volumes;
    for(const std::vector<std::size_t>& cells : parts)
      volumes.push_back(volume(cells));
    const auto vertices_of = [&](const std::size_t p, const auto& f) {
      for(const std::size_t t : parts[p])
        for(const int v : m_cells[t])
          f(static_cast<std::size_t>(v));
    };
    const std::vector<std::size_t> owners
      = owners_of_fragments(volumes, static_cast<std::size_t>(m_points.rows()), vertices_of);
    std::vector<std::vector<std::size_t>> surfaces;
    std::vector<std::size_t> index(parts.size());
    for(std::size_t p = 0; p < parts.size(); ++p)
    {
      if(owners[p] == p)
      {
        index[p] = m_cells_of_parts.size();
        m_cells_of_parts.emplace_back();
        surfaces.push_back(std::move(m_outer_surfaces[p]));
      }
      std::vector<std::size_t>& cells = m_cells_of_parts[index[owners[p]]];
      cells.insert(cells.end(), parts[p].begin(), parts[p].end());
    }
    for(std::vector<std::size_t>& cells : m_cells_of_parts)
      std::sort(cells.begin(), cells.end());
    m_outer_surfaces = std::move(surfaces);
  }

  // A surface with its own vertex indices, without the vertices of the pose.
  Surface_component_3 surface_of(const std::vector<std::size_t>& surface) const
  {
    Surface_component_3 component;
    for(const std::size_t i : surface)
      component.origins.insert(component.origins.end(), m_triangles[i].begin(),
                               m_triangles[i].end());
    sort_and_make_unique(component.origins);
    for(const std::size_t i : surface)
    {
      component.triangles.push_back(m_triangles[i]);
      for(std::size_t& v : component.triangles.back())
        v = index_in(component.origins, v);
      component.face_of_triangle.push_back(i);
    }
    component.points = rows_at(m_boundary_points, component.origins);
    return component;
  }

  const Point_matrix& m_points;
  const std::vector<std::array<int, 4>>& m_cells;
  const Eigen::VectorXd& m_volumes;
  const Cell_faces m_faces;
  const std::vector<std::size_t> m_boundary_faces;
  std::vector<Index_triangle> m_triangles; // of the boundary
  std::vector<std::size_t> m_boundary_vertices;
  Point_matrix m_boundary_points;
  std::vector<std::vector<std::size_t>> m_cells_of_parts;
  std::vector<std::vector<std::size_t>> m_outer_surfaces; // boundary triangles of each part
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_COMPLEX_PARTS_H
