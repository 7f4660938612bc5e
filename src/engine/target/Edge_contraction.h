// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_TARGET_EDGE_CONTRACTION_H
#define CANONICAL_POSE_3_ENGINE_TARGET_EDGE_CONTRACTION_H

#include "nearest_in_triangle.h"

#include <CGAL/Canonical_pose_3/Vertex_combination_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Contracts edges of a 2-manifold, with or without boundary, to one of their ends.
//
// CGAL's edge_collapse() takes 12 to 17 times the processor time (from 28 000 and 46 000 to 5 000
// vertices, by edge length), and does not express the vertices that are removed by those that remain.
class Edge_contraction
{
public:
  // `points`: with squares in the range of `double`.
  Edge_contraction(const Point_matrix& points, const std::vector<Index_triangle>& triangles)
    : m_points(static_cast<std::size_t>(points.rows())), m_triangles(triangles.size()),
      m_vertices(m_points.size()), m_next_corner(3 * triangles.size()),
      m_number_of_vertices(m_points.size())
  {
    for(std::size_t v = 0; v < m_points.size(); ++v)
      m_points[v] = points.row(static_cast<Eigen::Index>(v)).transpose();
    for(std::size_t f = triangles.size(); f-- > 0;)
      for(std::size_t k = 0; k < 3; ++k)
      {
        m_triangles[f][k] = static_cast<int>(triangles[f][k]);
        add_corner(m_triangles[f][k], static_cast<int>(3 * f + k));
      }
    for(std::size_t v = 0; v < m_points.size(); ++v)
    {
      find_star(static_cast<int>(v));
      m_vertices[v].is_on_boundary = std::any_of(m_neighbors.begin(), m_neighbors.end(),
                                                 [](const Neighbor& w) { return w.faces == 1; });
    }
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  bool is_removed(const std::size_t v) const { return m_vertices[v].is_removed; }
  bool is_removed_triangle(const std::size_t f) const { return m_triangles[f][0] == NONE; }
  // The corners of a triangle that was not removed.
  const std::array<int, 3>& triangle(const std::size_t f) const { return m_triangles[f]; }
  // The removed vertices, in order, in terms of those that were left.
  const std::vector<Vertex_combination_3>& combinations() const { return m_combinations; }

  void keep(const std::size_t v) { m_vertices[v].is_kept = true; }

  // Removes vertices with edges shorter than `length`, in order, until `number` are left. Those to
  // which an edge was contracted remain: otherwise, entire rows of vertices would be contracted to
  // one.
  void contract_edges(const double length, const std::size_t number)
  {
    ++m_pass;
    for(std::size_t v = 0; v < m_vertices.size() && m_number_of_vertices > number; ++v)
      if(!m_vertices[v].is_removed && !m_vertices[v].is_kept && m_vertices[v].pass != m_pass)
        contract_an_edge(static_cast<int>(v), length * length);
  }

private:
  static constexpr int NONE = -1;
  // A normal must not turn by more than 78 degrees.
  static constexpr double LEAST_COSINE = 0.2;
  // The height of a tip counts twice compared to the length of an edge.
  static constexpr double WEIGHT_OF_HEIGHT = 4;

  struct Vertex
  {
    int first_corner = NONE;
    int number_of_faces = 0;
    int mark = 0;
    int pass = 0; // the last one in which an edge was contracted to it
    bool is_on_boundary = false, is_removed = false, is_kept = false;
  };

  struct Neighbor
  {
    int vertex, faces; // number of faces at the edge
    double squared_length;
  };

  Vertex& at(const int v) { return m_vertices[static_cast<std::size_t>(v)]; }
  const Eigen::Vector3d& point(const int v) const { return m_points[static_cast<std::size_t>(v)]; }
  std::array<int, 3>& face(const int corner)
  {
    return m_triangles[static_cast<std::size_t>(corner) / 3];
  }
  // The next and the previous vertex of the triangle of a corner.
  std::pair<int, int> others(const int corner)
  {
    const std::array<int, 3>& t = face(corner);
    const int k = corner % 3;
    return {t[static_cast<std::size_t>((k + 1) % 3)], t[static_cast<std::size_t>((k + 2) % 3)]};
  }

  void add_corner(const int v, const int corner)
  {
    m_next_corner[static_cast<std::size_t>(corner)] = at(v).first_corner;
    at(v).first_corner = corner;
    ++at(v).number_of_faces;
  }

  // Calls f(corner) for each corner of v, and forgets those of removed triangles.
  template <class Function>
  void for_each_corner(const int v, const Function& f)
  {
    for(int* link = &at(v).first_corner; *link != NONE;)
    {
      const int corner = *link;
      int& next = m_next_corner[static_cast<std::size_t>(corner)];
      if(face(corner)[0] == NONE)
        *link = next;
      else
      {
        f(corner);
        link = &next;
      }
    }
  }

  // Stores corners and neighbors of v.
  void find_star(const int v)
  {
    m_corners.clear();
    m_neighbors.clear();
    for_each_corner(v, [&](const int corner) {
      m_corners.push_back(corner);
      const auto [next, previous] = others(corner);
      for(const int w : {next, previous})
      {
        const auto known = std::find_if(m_neighbors.begin(), m_neighbors.end(),
                                        [w = w](const Neighbor& n) { return n.vertex == w; });
        if(known != m_neighbors.end())
          ++known->faces;
        else
          m_neighbors.push_back({w, 1, (point(w) - point(v)).squaredNorm()});
      }
    });
  }

  // Contracts the best of the edges of v to its other end.
  void contract_an_edge(const int v, const double squared_length)
  {
    find_star(v);
    double least = squared_length;
    int best = NONE;
    Vertex_combination_3 combination;
    for(const Neighbor& neighbor : m_neighbors)
    {
      if(!(neighbor.squared_length < least) || (at(v).is_on_boundary && neighbor.faces != 1)
         || !keeps_topology(neighbor))
        continue;
      Vertex_combination_3 candidate;
      const double cost = neighbor.squared_length
                          + WEIGHT_OF_HEIGHT * squared_height(v, neighbor.vertex, candidate);
      if(cost < least)
      {
        least = cost;
        best = neighbor.vertex;
        combination = candidate;
      }
    }
    if(best != NONE)
      contract(v, best, combination);
  }

  // Whether the surface remains a manifold of the same topology if the edge of the last star to
  // `neighbor` is contracted (the link condition).
  bool keeps_topology(const Neighbor& neighbor)
  {
    ++m_mark;
    for(const Neighbor& w : m_neighbors)
      at(w.vertex).mark = m_mark;
    int common = 0;
    for_each_corner(neighbor.vertex, [&](const int corner) {
      const auto [next, previous] = others(corner);
      for(const int w : {next, previous})
        if(at(w).mark == m_mark)
        {
          at(w).mark = 0;
          ++common;
        }
    });
    return common == neighbor.faces
           && std::all_of(m_corners.begin(), m_corners.end(), [&](const int corner) {
                const auto [next, previous] = others(corner);
                if(next != neighbor.vertex && previous != neighbor.vertex)
                  return true;
                const Vertex& apex = at(next == neighbor.vertex ? previous : next);
                return apex.number_of_faces > (apex.is_on_boundary ? 1 : 3);
              });
  }

  // The squared distance of v from its star after a contraction to w, and the nearest point as a
  // combination; infinite if the surface would be folded over.
  double squared_height(const int v, const int w, Vertex_combination_3& combination)
  {
    double least = (std::numeric_limits<double>::infinity)();
    combination.vertex = static_cast<std::size_t>(v);
    for(const int corner : m_corners)
    {
      const auto [next, previous] = others(corner);
      if(next == w || previous == w)
        continue;
      const Eigen::Vector3d &a = point(next), &b = point(previous);
      const Eigen::Vector3d before = (a - point(v)).cross(b - point(v)),
                            after = (a - point(w)).cross(b - point(w));
      const double size_before = before.squaredNorm(), size_after = after.squaredNorm();
      const double product = before.dot(after);
      if(!(size_after > 0)
         || (size_before > 0
             && !(product > 0
                  && product * product > LEAST_COSINE * LEAST_COSINE * size_before * size_after)))
        return (std::numeric_limits<double>::infinity)();
      const std::array<double, 3> weights = nearest_in_triangle(point(v), point(w), a, b);
      const double squared_distance
        = (weights[0] * point(w) + weights[1] * a + weights[2] * b - point(v)).squaredNorm();
      if(squared_distance < least)
      {
        least = squared_distance;
        combination.vertices = {static_cast<std::size_t>(w), static_cast<std::size_t>(next),
                                static_cast<std::size_t>(previous)};
        combination.weights = weights;
      }
    }
    return least;
  }

  void contract(const int v, const int w, const Vertex_combination_3& combination)
  {
    m_combinations.push_back(combination);
    at(w).pass = m_pass;
    at(v).is_removed = true;
    --m_number_of_vertices;
    for(const int corner : m_corners)
    {
      const auto [next, previous] = others(corner);
      if(next == w || previous == w)
      {
        --at(next).number_of_faces;
        --at(previous).number_of_faces;
        face(corner)[0] = NONE;
      }
      else
      {
        face(corner)[static_cast<std::size_t>(corner % 3)] = w;
        add_corner(w, corner);
      }
    }
  }

  std::vector<Eigen::Vector3d> m_points;
  std::vector<std::array<int, 3>> m_triangles; // the first corner is NONE if removed
  std::vector<Vertex> m_vertices;
  std::vector<int> m_next_corner; // corner f * 3 + k; the list of each vertex
  std::size_t m_number_of_vertices;
  std::vector<Vertex_combination_3> m_combinations;
  std::vector<int> m_corners; // of the last star
  std::vector<Neighbor> m_neighbors;
  int m_mark = 0, m_pass = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_TARGET_EDGE_CONTRACTION_H
