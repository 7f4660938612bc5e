// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_BODY_MESH_3_EMBEDDER_H
#define CANONICAL_POSE_3_ENGINE_BODY_MESH_3_EMBEDDER_H

#include "mesh_3_complex.h"

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/internal/body/body_cells.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Embeds points in the cells of a complex.
class Mesh_3_embedder
{
public:
  explicit Mesh_3_embedder(const Mesh_3_complex& complex)
    : m_complex(complex), m_triangulation(complex.triangulation())
  {
    for(const Cell_handle cell : cells_in_complex(complex))
    {
      m_cells.emplace_back();
      for(int k = 0; k < 4; ++k)
      {
        const auto found = m_row.emplace(cell->vertex(k), static_cast<int>(m_vertices.size()));
        if(found.second)
          m_vertices.push_back(cell->vertex(k));
        m_cells.back()[k] = found.first->second;
      }
    }
  }

  // The complex and the points are smaller than the body by a factor of 2^exponent.
  Embedded_body_3 body(const Point_matrix& points, const int exponent)
  {
    std::vector<Eigen::Triplet<double>> triplets;
    for(Eigen::Index i = 0; i < points.rows(); ++i)
    {
      const Place place = find_place(points.row(i));
      if(!(place.excess <= LARGEST_EXCESS))
        throw std::runtime_error("the cells of Mesh_3 miss the part of the surface around vertex "
                                 + std::to_string(i) + ": it is too thin for their size");
      for(int k = 0; k < 4; ++k)
        triplets.emplace_back(i, m_row.at(place.cell->vertex(k)), place.coordinates[k]);
    }
    Eigen::SparseMatrix<double> embedding(points.rows(),
                                          static_cast<Eigen::Index>(m_vertices.size()));
    embedding.setFromTriplets(triplets.begin(), triplets.end());

    Point_matrix body_points(embedding.cols(), 3);
    for(Eigen::Index i = 0; i < body_points.rows(); ++i)
      for(int k = 0; k < 3; ++k)
        body_points(i, k) = std::ldexp(position(m_vertices[i])[k], exponent);
    return Embedded_body_3(std::move(body_points), m_cells, std::move(embedding));
  }

private:
  using Cell_handle = Mesh_3_complex::Cell_handle;
  using Vertex_handle = Mesh_3_complex::Vertex_handle;

  // A point farther from a cell than its height has a coordinate below -1.
  static constexpr double LARGEST_EXCESS = 2;
  static constexpr int NUMBER_OF_RINGS = 4;

  struct Place
  {
    Cell_handle cell;
    Eigen::Vector4d coordinates;
    double excess = std::numeric_limits<double>::infinity(); // 0: inside; or of the most negative
  };

  static Eigen::Vector3d position(const Vertex_handle v)
  {
    const auto& p = v->point();
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  }

  static Place place_in(const Cell_handle cell, const Eigen::Vector3d& point)
  {
    Place place;
    place.cell = cell;
    place.coordinates
      = barycentric_coordinates({position(cell->vertex(0)), position(cell->vertex(1)),
                                 position(cell->vertex(2)), position(cell->vertex(3))},
                                point);
    place.excess = (std::max)(0., -place.coordinates.minCoeff());
    return place;
  }

  // Returns the cell that contains the point; outside of the complex, the best one among growing
  // rings of cells around the located cell, until one is close enough.
  Place find_place(const Eigen::Vector3d& point)
  {
    m_hint = m_triangulation.locate(
      Mesh_3_triangulation::Weighted_point(Indexed_mesh::Point(point[0], point[1], point[2])),
      m_hint);
    if(m_complex.is_in_complex(m_hint))
      return place_in(m_hint, point);
    Place best;
    std::vector<Cell_handle> ring = {m_hint};
    for(int i = 0; i < NUMBER_OF_RINGS && !(best.excess <= 1); ++i)
    {
      ring = cells_around(ring);
      for(const Cell_handle cell : ring)
        if(m_complex.is_in_complex(cell))
        {
          const Place place = place_in(cell, point);
          if(place.excess < best.excess)
            best = place;
        }
    }
    return best;
  }

  // Returns the cells that share a vertex with one of the given cells.
  std::vector<Cell_handle> cells_around(const std::vector<Cell_handle>& cells) const
  {
    std::vector<Cell_handle> result;
    std::unordered_set<Vertex_handle> visited;
    for(const Cell_handle cell : cells)
      for(int k = 0; k < 4; ++k)
        if(!m_triangulation.is_infinite(cell->vertex(k)) && visited.insert(cell->vertex(k)).second)
          m_triangulation.incident_cells(cell->vertex(k), std::back_inserter(result));
    return result;
  }

  const Mesh_3_complex& m_complex;
  const Mesh_3_triangulation& m_triangulation;
  std::vector<Vertex_handle> m_vertices;
  std::unordered_map<Vertex_handle, int> m_row;
  std::vector<std::array<int, 4>> m_cells;
  Cell_handle m_hint;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_BODY_MESH_3_EMBEDDER_H
