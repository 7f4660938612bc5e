// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_MANIFOLD_BUILDER_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_MANIFOLD_BUILDER_H

#include "Side_pairing.h"
#include "Soup_topology.h"

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Creates an oriented 2-manifold from triangles: stitches, orients, and splits vertices. Corner
// 3t+k is corner k of triangle t, and side 3t+k runs from it to the next corner.
class Manifold_builder
{
public:
  using Side = Corner_table::Index;

  static constexpr Side NONE = Corner_table::NONE;

  // `topology`: of the triangles of its soup.
  explicit Manifold_builder(const Soup_topology& topology)
    : m_topology(topology), m_points(topology.soup.points()), m_soup(topology.soup.triangle_soup())
  {}

  // Sets triangles, face_of_triangle, origins and representatives.
  void run(Repaired_surface_3& result)
  {
    drop_if(m_topology.is_duplicate);
    check_area();
    if(m_soup.triangles.size() == m_topology.faces.size())
      pair_sides(m_topology.corners, m_topology.places);
    else // the topology includes the sides of duplicates
    {
      const Corner_table corners(number_of_rows(), m_soup.triangles);
      pair_sides(corners, places_of_boundary(m_points, corners));
    }
    find_fans();
    cut_edges_that_coincide();
    make_vertices(result);
    sew_slits(result.triangles);
    result.face_of_triangle = std::move(m_soup.face_of_triangle);
  }

  // Twin of each side, which runs in the opposite direction, or NONE.
  const std::vector<Side>& twins() const { return m_twin; }

  static std::size_t next(const std::size_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static std::size_t previous(const std::size_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

private:
  std::size_t row(const std::size_t c) const { return m_soup.triangles[c / 3][c % 3]; }

  std::size_t number_of_rows() const { return static_cast<std::size_t>(m_points.rows()); }

  void drop_if(const std::vector<bool>& is_dropped)
  {
    m_soup.keep_if([&](const std::size_t t) { return !is_dropped[t]; });
  }

  void check_area() const
  {
    if(std::all_of(m_soup.triangles.begin(), m_soup.triangles.end(),
                   [&](const Index_triangle& t) { return is_degenerate(m_points, t); }))
      throw std::invalid_argument("the surface has no area: all its faces are degenerate");
  }

  // Stitched triangles have different edges.
  void pair_sides(const Corner_table& corners, std::vector<std::size_t> places)
  {
    m_place = std::move(places);
    bool is_sewn = false;
    for(std::size_t v = 0; v < m_place.size(); ++v)
      is_sewn = is_sewn || m_place[v] != v;
    if(!is_sewn)
      return take(Side_pairing(m_points, corners));
    const std::vector<Index_triangle> placed = placed_triangles();
    m_soup.keep_if([&](const std::size_t t) { return !names_a_vertex_twice(placed[t]); });
    drop_if(is_duplicate_face(number_of_rows(), placed_triangles()));
    check_area();
    take(Side_pairing(m_points, Corner_table(number_of_rows(), placed_triangles())));
  }

  std::vector<Index_triangle> placed_triangles() const
  {
    std::vector<Index_triangle> result = m_soup.triangles;
    for(Index_triangle& t : result)
      for(std::size_t& v : t)
        v = m_place[v];
    return result;
  }

  // Reverses triangles and their sides.
  void take(const Side_pairing& pairing)
  {
    const auto turned = [&](const Side side) {
      return side != NONE && pairing.is_flipped(side / 3)
               ? static_cast<Side>(side + 2 - 2 * (side % 3))
               : side;
    };
    m_twin.resize(pairing.twins().size());
    for(Side side = 0; side < m_twin.size(); ++side)
      m_twin[turned(side)] = turned(pairing.twins()[side]);
    m_complex_edges = pairing.complex_edges();
    for(std::vector<std::size_t>& sides : m_complex_edges)
      std::transform(sides.begin(), sides.end(), sides.begin(), turned);
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if(pairing.is_flipped(t))
        std::swap(m_soup.triangles[t][1], m_soup.triangles[t][2]);
  }

  // A fan consists of corners at one position that are connected by twins. It becomes one vertex.
  void find_fans()
  {
    m_fan.assign(m_twin.size(), NONE);
    m_first_of_fan.clear();
    for(std::size_t first = 0; first < m_twin.size(); ++first)
    {
      if(m_fan[first] != NONE)
        continue;
      const auto fan = static_cast<Side>(m_first_of_fan.size());
      std::size_t c = first;
      do
      {
        m_fan[c] = fan;
        c = m_twin[c] == NONE ? NONE : next(m_twin[c]);
      } while(c != NONE && c != first);
      if(c == NONE) // the fan is open: also traverse it backward
        for(c = m_twin[previous(first)]; c != NONE; c = m_twin[previous(c)])
          m_fan[c] = fan;
      m_first_of_fan.push_back(static_cast<Side>(first));
    }
  }

  // Two edges between the same two fans would be one edge with more than two triangles. Separating
  // all twins there splits the fans.
  void cut_edges_that_coincide()
  {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    bool is_cut = false;
    for(const std::vector<std::size_t>& sides : m_complex_edges)
    {
      edges.clear();
      for(const std::size_t side : sides)
        if(m_twin[side] == NONE || side < m_twin[side])
          edges.push_back(std::minmax({m_fan[side], m_fan[next(side)]}));
      std::sort(edges.begin(), edges.end());
      if(std::adjacent_find(edges.begin(), edges.end()) == edges.end())
        continue;
      for(const std::size_t side : sides)
        m_twin[side] = NONE;
      is_cut = true;
    }
    if(is_cut)
      find_fans();
  }

  // Rows that share a fan are merged into the smallest one.
  std::vector<std::size_t> representatives() const
  {
    const std::size_t n = number_of_rows();
    Disjoint_sets rows(n);
    std::vector<bool> has_corner(n, false);
    for(std::size_t c = 0; c < m_fan.size(); ++c)
    {
      has_corner[row(c)] = true;
      if(const std::size_t first = row(m_first_of_fan[m_fan[c]]); first != row(c))
        rows.unite(row(c), first);
    }
    for(std::size_t v = 0; v < n; ++v)
      if(!has_corner[v]) // all its faces have been removed
        rows.unite(v, m_place[v]);
    const Component_labels labels = label_components(rows);
    std::vector<std::size_t> result(n);
    for(std::size_t v = 0; v < n; ++v)
      result[v] = labels.first_items[labels.of_items[v]];
    return result;
  }

  // Vertices are sorted by the row of which they are copies, then by their first corner.
  void make_vertices(Repaired_surface_3& result)
  {
    result.representatives = representatives();
    const Buckets<Side> fans_of_rows(number_of_rows(), [&](const auto& put) {
      for(Side fan = 0; fan < m_first_of_fan.size(); ++fan)
        put(result.representatives[row(m_first_of_fan[fan])], fan);
    });
    std::vector<std::size_t> vertex_of_fan(m_first_of_fan.size());
    result.origins.reserve(m_first_of_fan.size());
    for(std::size_t v = 0; v < number_of_rows(); ++v)
      for(const Side fan : fans_of_rows[v])
      {
        vertex_of_fan[fan] = result.origins.size();
        result.origins.push_back(v);
      }
    result.triangles = std::move(m_soup.triangles);
    for(std::size_t c = 0; c < m_fan.size(); ++c)
      result.triangles[c / 3][c % 3] = vertex_of_fan[m_fan[c]];
  }

  // Two sides whose twins were separated may still connect the same two vertices.
  void sew_slits(const std::vector<Index_triangle>& triangles)
  {
    const auto vertex = [&](const std::size_t c) { return triangles[c / 3][c % 3]; };
    std::vector<std::size_t> leaving(m_first_of_fan.size(), NONE);
    for(std::size_t side = 0; side < m_twin.size(); ++side)
      if(m_twin[side] == NONE)
        leaving[vertex(side)] = side;
    for(const std::size_t side : leaving)
    {
      const std::size_t back = side == NONE ? NONE : leaving[vertex(next(side))];
      if(back != NONE && vertex(next(back)) == vertex(side))
        m_twin[side] = back;
    }
  }

  const Soup_topology& m_topology;
  const Point_matrix& m_points;
  Triangle_soup m_soup;
  std::vector<std::size_t> m_place;
  std::vector<Side> m_twin;
  std::vector<std::vector<std::size_t>> m_complex_edges;
  std::vector<Side> m_fan, m_first_of_fan;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_MANIFOLD_BUILDER_H
