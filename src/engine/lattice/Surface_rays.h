// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_SURFACE_RAYS_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_SURFACE_RAYS_H

#include "Clipped_triangle.h"

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Row_points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// Intersects rays with triangles, using a uniform grid. (Building CGAL's AABB tree takes longer
// than all ray queries of a body.)
class Surface_rays
{
public:
  struct Hit
  {
    double distance;
    std::size_t face;
    bool is_exit; // the ray runs along the normal of the face
  };

  Surface_rays(const Row_points& points, const std::vector<Index_triangle>& triangles)
    : m_points(points), m_triangles(triangles)
  {
    choose_cells();
    fill_cells();
  }

  // Calls visit(hit) for the hits at positive distances, in the order of distance, except those on
  // `own_face`, until it returns false. `direction` has length 1, `origin` is inside the bounding
  // box.
  template <class Visitor>
  void trace(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
             const std::size_t own_face, const Visitor& visit) const
  {
    std::array<int, 3> cell, step;
    Eigen::Vector3d next, delta;
    for(int k = 0; k < 3; ++k)
    {
      cell[k] = coordinate(origin[k], k);
      step[k] = direction[k] > 0 ? 1 : -1;
      const double border = m_low[k] + m_size * (cell[k] + (direction[k] > 0 ? 1 : 0));
      const bool moves = direction[k] != 0;
      next[k]
        = moves ? (border - origin[k]) / direction[k] : std::numeric_limits<double>::infinity();
      delta[k] = moves ? m_size / std::abs(direction[k]) : std::numeric_limits<double>::infinity();
    }
    std::vector<Hit> hits;
    for(double begin = 0;;)
    {
      int axis;
      double end = next.minCoeff(&axis);
      const int next_row = cell[axis] + step[axis];
      const bool is_last = next_row < 0 || next_row >= m_cells[axis];
      if(is_last) // a face on the border may be hit slightly behind it due to rounding
        end = std::numeric_limits<double>::infinity();
      hits.clear();
      for(const int face : m_faces_of_cells[index(cell)])
        if(const auto f = static_cast<std::size_t>(face); f != own_face)
          intersect(origin, direction, f, begin, end, hits);
      sort(hits);
      for(const Hit& hit : hits)
        if(!visit(hit))
          return;
      if(is_last)
        return;
      cell[axis] = next_row;
      next[axis] += delta[axis];
      begin = (std::max)(begin, end);
    }
  }

private:
  static constexpr double TRIANGLE_SIZES_PER_CELL = 3;
  static constexpr double CELLS_PER_TRIANGLE = 8;
  static constexpr double ENTRIES_PER_TRIANGLE = 32; // of the lists of the cells, up to a factor
  static constexpr double MARGIN = 1e-6;             // of a cell, well above rounding errors
  static constexpr double SLACK = 1e-9;              // of a triangle
  static constexpr std::size_t CELLS_OF_SMALL_BOX = 64;

  void choose_cells()
  {
    const Eigen::Vector3d low = m_points.colwise().minCoeff(), high = m_points.colwise().maxCoeff();
    const Eigen::Vector3d extent = high - low;
    double area = 0, perimeter = 0;
    for(const Index_triangle& t : m_triangles)
    {
      area += 0.5 * normal(t).norm();
      for(std::size_t k = 0; k < 3; ++k)
        perimeter += (point(t[k]) - point(t[(k + 1) % 3])).norm();
    }
    const double count = static_cast<double>(m_triangles.size());
    m_size = TRIANGLE_SIZES_PER_CELL * std::sqrt(area / count);
    m_size = (std::max)(m_size, 1e-6 * extent.maxCoeff());
    const auto cells = [&] { return ((extent / m_size).array().floor() + 1).prod(); };
    const auto entries = [&] { return (area / m_size + perimeter) / m_size + count; };
    while(cells() > CELLS_PER_TRIANGLE * count + 4096 || entries() > ENTRIES_PER_TRIANGLE * count)
      m_size *= 1.25;
    m_low = low;
    for(int k = 0; k < 3; ++k)
      m_cells[k] = static_cast<int>(extent[k] / m_size) + 1;
  }

  void fill_cells()
  {
    const std::size_t n = static_cast<std::size_t>(m_cells[0])
                          * static_cast<std::size_t>(m_cells[1])
                          * static_cast<std::size_t>(m_cells[2]);
    m_faces_of_cells
      = Buckets<int>::sorted(n, m_triangles.size(), [&](const std::size_t f, const auto& put) {
          for_each_cell(m_triangles[f], [&](const std::size_t c) { put(c, static_cast<int>(f)); });
        });
  }

  // A range of cells along the three axes.
  struct Box
  {
    std::array<int, 3> low, high;
    std::size_t size() const
    {
      std::size_t result = 1;
      for(int k = 0; k < 3; ++k)
        result *= static_cast<std::size_t>(high[k] - low[k] + 1);
      return result;
    }
  };

  Box bounding_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                   const double margin) const
  {
    Box box;
    for(int k = 0; k < 3; ++k)
    {
      box.low[k] = coordinate(low[k] - margin, k);
      box.high[k] = coordinate(high[k] + margin, k);
    }
    return box;
  }

  // Calls the function for the cells close to a triangle; its bounding box may have many more.
  template <class Function>
  void for_each_cell(const Index_triangle& t, const Function& f) const
  {
    const Eigen::Vector3d a = point(t[0]), b = point(t[1]), c = point(t[2]);
    const Box box
      = bounding_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), MARGIN * m_size);
    if(box.size() <= CELLS_OF_SMALL_BOX)
      for_each_cell_near_plane(box, t, f);
    else
      for_each_cell_in_slabs(box, Clipped_triangle(a, b, c), f);
  }

  // Calls the function for the cells of the bounding box of a triangle that are close to its plane.
  template <class Function>
  void for_each_cell_near_plane(const Box& box, const Index_triangle& t, const Function& f) const
  {
    const Eigen::Vector3d a = point(t[0]);
    const Eigen::Vector3d n = normal(t).stableNormalized();
    const double reach = (0.5 * n.cwiseAbs().sum() + MARGIN) * m_size;
    std::array<int, 3> cell;
    for(cell[0] = box.low[0]; cell[0] <= box.high[0]; ++cell[0])
      for(cell[1] = box.low[1]; cell[1] <= box.high[1]; ++cell[1])
        for(cell[2] = box.low[2]; cell[2] <= box.high[2]; ++cell[2])
        {
          const Eigen::Vector3d center
            = m_low + m_size * (Eigen::Vector3d(cell[0], cell[1], cell[2]).array() + 0.5).matrix();
          if(std::abs(n.dot(center - a)) <= reach)
            f(index(cell));
        }
  }

  // Clips the triangle to slabs of cells along the longest axis of the box, and each part to rows
  // along the next axis; the result gives the range along the shortest axis.
  template <class Function>
  void for_each_cell_in_slabs(const Box& box, const Clipped_triangle& triangle,
                              const Function& f) const
  {
    std::array<int, 3> axes = {0, 1, 2};
    std::sort(axes.begin(), axes.end(), [&](const int a, const int b) {
      const int of_a = box.high[a] - box.low[a], of_b = box.high[b] - box.low[b];
      return of_a != of_b ? of_a > of_b : a < b;
    });
    const double margin
      = MARGIN * m_size + 4 * SLACK * (triangle.high() - triangle.low()).maxCoeff();
    const auto clipped = [&](Clipped_triangle part, const int axis, const int row) {
      const double low = m_low[axis] + m_size * row;
      part.clip(axis, low - margin, low + m_size + margin);
      return part;
    };
    std::array<int, 3> cell;
    for(cell[axes[0]] = box.low[axes[0]]; cell[axes[0]] <= box.high[axes[0]]; ++cell[axes[0]])
    {
      const Clipped_triangle slab = clipped(triangle, axes[0], cell[axes[0]]);
      if(slab.is_empty())
        continue;
      const Box rows = bounding_box(slab.low(), slab.high(), margin);
      for(cell[axes[1]] = rows.low[axes[1]]; cell[axes[1]] <= rows.high[axes[1]]; ++cell[axes[1]])
      {
        const Clipped_triangle part = clipped(slab, axes[1], cell[axes[1]]);
        if(part.is_empty())
          continue;
        const Box column = bounding_box(part.low(), part.high(), margin);
        for(cell[axes[2]] = column.low[axes[2]]; cell[axes[2]] <= column.high[axes[2]];
            ++cell[axes[2]])
          f(index(cell));
      }
    }
  }

  // Moeller & Trumbore 1997, with some slack at the edges, so that no ray slips between two faces.
  void intersect(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                 const std::size_t face, const double begin, const double end,
                 std::vector<Hit>& hits) const
  {
    const Index_triangle& t = m_triangles[face];
    const Eigen::Vector3d a = point(t[0]);
    const Eigen::Vector3d e = point(t[1]) - a, f = point(t[2]) - a;
    const Eigen::Vector3d p = direction.cross(f);
    const double determinant = e.dot(p);
    if(determinant == 0)
      return;
    const double inverse = 1 / determinant;
    const Eigen::Vector3d from = origin - a;
    const double u = from.dot(p) * inverse;
    if(!(u >= -SLACK && u <= 1 + SLACK))
      return;
    const Eigen::Vector3d q = from.cross(e);
    const double v = direction.dot(q) * inverse;
    if(!(v >= -SLACK && u + v <= 1 + SLACK))
      return;
    const double distance = f.dot(q) * inverse;
    if(distance > begin && distance <= end)
      hits.push_back({distance, face, determinant < 0});
  }

  static void sort(std::vector<Hit>& hits)
  {
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.face < b.face;
    });
  }

  Eigen::Vector3d point(const std::size_t v) const
  {
    return m_points.row(static_cast<Eigen::Index>(v));
  }

  Eigen::Vector3d normal(const Index_triangle& t) const
  {
    return (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
  }

  int coordinate(const double x, const int axis) const
  {
    return (std::min)((std::max)(static_cast<int>((x - m_low[axis]) / m_size), 0),
                      m_cells[axis] - 1);
  }

  std::size_t index(const std::array<int, 3>& cell) const
  {
    return (static_cast<std::size_t>(cell[0]) * static_cast<std::size_t>(m_cells[1])
            + static_cast<std::size_t>(cell[1]))
             * static_cast<std::size_t>(m_cells[2])
           + static_cast<std::size_t>(cell[2]);
  }

  const Row_points& m_points;
  const std::vector<Index_triangle>& m_triangles;
  Eigen::Vector3d m_low;
  double m_size = 0;
  std::array<int, 3> m_cells;
  Buckets<int> m_faces_of_cells;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_SURFACE_RAYS_H
