// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_COPIES_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_COPIES_H

#include "Lattice_pieces.h"

#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Copies of the cubes of a lattice, one for each part of the solid that passes through a cube, and
// the nodes shared by copies of neighboring cubes where a part extends from one to the other
// (virtual nodes, Molino et al. 2004). Parts are distinguished by geodesics: two pieces belong to
// the same part if their distance on the surface is similar to that through the solid.
class Lattice_copies
{
public:
  Lattice_copies(const std::vector<Index_triangle>& triangles, const Lattice_pieces& pieces,
                 const Geodesic_bounds& bounds)
    : m_triangles(triangles), m_pieces(pieces), m_bounds(bounds)
  {
    make_copies();
    number_nodes();
  }

  std::size_t number_of_nodes() const { return m_number_of_nodes; }

  // the copies that form the body
  const std::vector<std::size_t>& held() const { return m_held; }

  // per copy: its cube and its eight nodes; bit k of the index of a node is its side along axis k
  const std::vector<int>& cells() const { return m_cells; }
  const std::vector<std::array<int, 8>>& nodes() const { return m_nodes; }

  // The faces of a copy that intersect its cube.
  const std::vector<int>& faces(const std::size_t copy) const { return m_faces[copy]; }

  // The copy that contains a piece of `face` in `cell`.
  std::size_t copy_of(const std::size_t cell, const std::size_t face) const
  {
    const auto piece
      = std::lower_bound(m_pieces.begin(cell), m_pieces.end(cell), static_cast<int>(face),
                         [](const Lattice_piece& p, const int f) { return p.face < f; });
    return m_copy_of_piece[m_pieces.place(piece)];
  }

private:
  // The representatives of a class of pieces: those nearest to the surface, and among these those
  // with the shortest chord.
  using Samples = std::vector<Lattice_piece>;
  static constexpr std::size_t NUMBER_OF_SAMPLES = 4;

  struct Cell_classes
  {
    std::vector<std::size_t> class_of_piece;
    std::vector<Samples> samples;
  };

  // An end of a chord, and its distance to a cube.
  struct End
  {
    std::size_t vertex;
    double way;
  };
  using Ends = boost::container::static_vector<End, 2>;

  // The nearer end of the chord of a piece, or both if they are about equally near. There is at
  // least one; for a chord that ends on a cap, it is the start.
  Ends ends(const Lattice_piece& p) const
  {
    const bool has_exit = p.exit_vertex != Lattice_piece::NONE;
    const double nearer = (std::min)(p.depth, p.rest) + m_pieces.spacing();
    Ends result;
    if(!has_exit || p.depth <= nearer)
      result.push_back({m_triangles[static_cast<std::size_t>(p.face)][0], p.depth});
    if(has_exit && p.rest <= nearer)
      result.push_back({static_cast<std::size_t>(p.exit_vertex), p.rest});
    return result;
  }

  // The distance on the surface may be somewhat larger than that through the solid.
  bool are_near(const End& a, const End& b) const
  {
    return m_bounds(a.vertex, b.vertex) <= 1.2 * (a.way + b.way + m_pieces.spacing());
  }

  // In the middle of long chords, one end is not conclusive (it may be where two fingers touch), so
  // both must agree. This cannot be required for short chords, for instance those of a sheet.
  bool are_near(const Lattice_piece& p, const Lattice_piece& q) const
  {
    const Ends of_p = ends(p), of_q = ends(q);
    const auto is_near = [&](const std::size_t i, const std::size_t j) {
      return are_near(of_p[i % of_p.size()], of_q[j % of_q.size()]);
    };
    const auto is_long = [&](const Ends& e) {
      return e.size() == 2 && (std::max)(e[0].way, e[1].way) > 2 * m_pieces.spacing();
    };
    if((is_near(0, 0) && is_near(1, 1)) || (is_near(0, 1) && is_near(1, 0)))
      return true;
    return !is_long(of_p) && !is_long(of_q)
           && (is_near(0, 0) || is_near(0, 1) || is_near(1, 0) || is_near(1, 1));
  }

  bool are_near(const Samples& a, const Samples& b) const
  {
    return std::any_of(a.begin(), a.end(), [&](const Lattice_piece& p) {
      return std::any_of(b.begin(), b.end(),
                         [&](const Lattice_piece& q) { return are_near(p, q); });
    });
  }

  // Numbers the subsets of [0, n) in the order of their first elements.
  static std::size_t number_classes(Disjoint_sets& sets, const std::size_t n,
                                    std::vector<std::size_t>& number)
  {
    const std::size_t none = n;
    std::vector<std::size_t> number_of_representative(n, none);
    std::size_t count = 0;
    number.resize(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      std::size_t& number_of_set = number_of_representative[sets.representative(i)];
      if(number_of_set == none)
        number_of_set = count++;
      number[i] = number_of_set;
    }
    return count;
  }

  std::vector<Samples> choose_samples(const Lattice_piece* pieces,
                                      const std::vector<std::size_t>& class_of_piece,
                                      const std::size_t number_of_classes) const
  {
    std::vector<Samples> samples(number_of_classes);
    for(std::size_t i = 0; i < class_of_piece.size(); ++i)
    {
      Samples& s = samples[class_of_piece[i]];
      const auto is_better = [](const Lattice_piece& p, const Lattice_piece& q) {
        const float way_of_p = (std::min)(p.depth, p.rest), way_of_q = (std::min)(q.depth, q.rest);
        return way_of_p != way_of_q ? way_of_p < way_of_q : p.rest < q.rest;
      };
      const auto place = std::upper_bound(s.begin(), s.end(), pieces[i], is_better);
      if(s.size() < NUMBER_OF_SAMPLES || place != s.end())
        s.insert(place, pieces[i]);
      if(s.size() > NUMBER_OF_SAMPLES)
        s.pop_back();
    }
    return samples;
  }

  // Pieces of a cube are merged if their faces share a vertex, then by distance.
  Cell_classes classify(const std::size_t cell) const
  {
    const Lattice_piece* const pieces = m_pieces.begin(cell);
    const std::size_t n = static_cast<std::size_t>(m_pieces.end(cell) - pieces);
    Disjoint_sets sets(n);
    std::vector<std::pair<std::size_t, std::size_t>> corners; // vertex, piece
    for(std::size_t i = 0; i < n; ++i)
      if(pieces[i].depth == 0)
        for(const std::size_t v : m_triangles[static_cast<std::size_t>(pieces[i].face)])
          corners.emplace_back(v, i);
    std::sort(corners.begin(), corners.end());
    for(std::size_t i = 1; i < corners.size(); ++i)
      if(corners[i].first == corners[i - 1].first)
        sets.unite(corners[i].second, corners[i - 1].second);

    Cell_classes result;
    const std::size_t fans = number_classes(sets, n, result.class_of_piece);
    result.samples = choose_samples(pieces, result.class_of_piece, fans);
    if(fans == 1)
      return result;
    Disjoint_sets classes(fans);
    for(std::size_t i = 0; i < fans; ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(classes.representative(i) != classes.representative(j)
           && are_near(result.samples[i], result.samples[j]))
          classes.unite(i, j);
    std::vector<std::size_t> class_of_fan;
    const std::size_t count = number_classes(classes, fans, class_of_fan);
    for(std::size_t& c : result.class_of_piece)
      c = class_of_fan[c];
    result.samples = choose_samples(pieces, result.class_of_piece, count);
    return result;
  }

  void make_copies()
  {
    const std::size_t n = m_pieces.size();
    std::vector<std::size_t> used;
    for(std::size_t c = 0; c < n; ++c)
      if(m_pieces.begin(c) != m_pieces.end(c))
        used.push_back(c);
    std::vector<Cell_classes> classes(used.size());
    for_each_block(used.size(), [&](std::size_t, const std::size_t begin, const std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        classes[i] = classify(used[i]);
    });
    m_first_copy.assign(n, 0);
    m_copy_of_piece.resize(m_pieces.number_of_places());
    for(std::size_t i = 0; i < used.size(); ++i)
    {
      const std::size_t c = used[i];
      m_first_copy[c] = m_cells.size();
      for(Samples& s : classes[i].samples)
      {
        m_cells.push_back(static_cast<int>(c));
        m_samples.push_back(std::move(s));
      }
      m_faces.resize(m_cells.size());
      for(const Lattice_piece* p = m_pieces.begin(c); p != m_pieces.end(c); ++p)
      {
        const std::size_t copy
          = m_first_copy[c]
            + classes[i].class_of_piece[static_cast<std::size_t>(p - m_pieces.begin(c))];
        m_copy_of_piece[m_pieces.place(p)] = copy;
        if(p->depth == 0)
          m_faces[copy].push_back(p->face);
      }
    }
  }

  // Calls f(a, b) for the copies of two neighboring cubes that belong together: a face or chord
  // passes through both, or they are near each other.
  template <class Function>
  void for_each_bridge(const std::size_t cell, const std::size_t next, const Function& f)
  {
    std::vector<std::pair<std::size_t, std::size_t>> bridges;
    const Lattice_piece *p = m_pieces.begin(cell), *q = m_pieces.begin(next);
    while(p != m_pieces.end(cell) && q != m_pieces.end(next))
      if(p->face < q->face)
        ++p;
      else if(q->face < p->face)
        ++q;
      else
        bridges.emplace_back(m_copy_of_piece[m_pieces.place(p++)],
                             m_copy_of_piece[m_pieces.place(q++)]);
    std::sort(bridges.begin(), bridges.end());
    bridges.erase(std::unique(bridges.begin(), bridges.end()), bridges.end());
    for(const auto& bridge : bridges)
      f(bridge.first, bridge.second);
    for(std::size_t a = m_first_copy[cell]; is_copy_of(a, cell); ++a)
      for(std::size_t b = m_first_copy[next]; is_copy_of(b, next); ++b)
        if(!std::binary_search(bridges.begin(), bridges.end(), std::make_pair(a, b))
           && are_near(m_samples[a], m_samples[b]))
          f(a, b);
  }

  bool is_copy_of(const std::size_t copy, const std::size_t cell) const
  {
    return copy < m_cells.size() && m_cells[copy] == static_cast<int>(cell);
  }

  void number_nodes()
  {
    Disjoint_sets corners(8 * m_cells.size());
    for(std::size_t i = 0; i < m_cells.size(); ++i)
    {
      const std::size_t cell = static_cast<std::size_t>(m_cells[i]);
      if(i > 0 && m_cells[i - 1] == m_cells[i])
        continue;
      for(int axis = 0; axis < 3; ++axis)
      {
        if(!m_pieces.has_next(m_cells[i], axis))
          continue;
        const std::size_t next = cell + static_cast<std::size_t>(m_pieces.stride(axis));
        if(m_pieces.begin(next) == m_pieces.end(next))
          continue;
        for_each_bridge(cell, next, [&](const std::size_t a, const std::size_t b) {
          const std::size_t bit = std::size_t(1) << axis;
          for(std::size_t corner = 0; corner < 8; ++corner)
            if(corner & bit)
              corners.unite(8 * a + corner, 8 * b + (corner ^ bit));
        });
      }
    }
    hold(corners);
    const int none = -1;
    std::vector<int> number(8 * m_cells.size(), none);
    m_nodes.resize(m_cells.size());
    for(const std::size_t i : m_held)
      for(std::size_t corner = 0; corner < 8; ++corner)
      {
        int& number_of_class = number[corners.representative(8 * i + corner)];
        if(number_of_class == none)
          number_of_class = static_cast<int>(m_number_of_nodes++);
        m_nodes[i][corner] = number_of_class;
      }
  }

  // Lists the copies that are connected to the surface. Chords that were partly discarded may leave
  // others.
  void hold(Disjoint_sets& corners)
  {
    Disjoint_sets parts(8 * m_cells.size());
    for(std::size_t i = 0; i < 8 * m_cells.size(); ++i)
    {
      parts.unite(i, corners.representative(i));
      parts.unite(i, i - i % 8);
    }
    std::vector<bool> is_held(8 * m_cells.size(), false);
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      if(!m_faces[i].empty())
        is_held[parts.representative(8 * i)] = true;
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      if(is_held[parts.representative(8 * i)])
        m_held.push_back(i);
  }

  const std::vector<Index_triangle>& m_triangles;
  const Lattice_pieces& m_pieces;
  const Geodesic_bounds& m_bounds;
  std::vector<int> m_cells;
  std::vector<Samples> m_samples;
  std::vector<std::vector<int>> m_faces;
  std::vector<std::size_t> m_first_copy;    // of each cube
  std::vector<std::size_t> m_copy_of_piece; // by its index
  std::vector<std::array<int, 8>> m_nodes;
  std::vector<std::size_t> m_held;
  std::size_t m_number_of_nodes = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_COPIES_H
