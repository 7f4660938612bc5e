// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_PIECES_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_PIECES_H

#include "Surface_rays.h"
#include "surface_chords.h"

#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A cube of the lattice that intersects a face or a chord starting on it. Lengths are measured
// along the chord, in the unit of the points.
struct Lattice_piece
{
  static constexpr int NONE = -1;

  int cell;
  int face;
  int exit_vertex = NONE;                             // the end of the chord
  float depth = 0;                                    // from the face to the cube
  float rest = (std::numeric_limits<float>::max)();   // from the cube to the end of the chord
  float length = (std::numeric_limits<float>::max)(); // of the chord
};

// The cubes of a lattice over a surface, and the pieces of the surface and of its chords in each.
class Lattice_pieces
{
public:
  Lattice_pieces(const Row_points& points, const std::vector<Index_triangle>& triangles,
                 const std::vector<Chord>& chords, const double spacing)
    : m_points(points), m_triangles(triangles), m_spacing(spacing)
  {
    m_low = points.colwise().minCoeff();
    const Eigen::Vector3d high = points.colwise().maxCoeff();
    for(int k = 0; k < 3; ++k)
      m_cells[k] = static_cast<int>((high[k] - m_low[k]) / spacing) + 1;
    sort(collect(chords));
  }

  // the number of cubes, most of them without pieces
  std::size_t size() const { return m_pieces.number_of_buckets(); }
  const Lattice_piece* begin(const std::size_t cell) const { return m_pieces[cell].begin(); }
  const Lattice_piece* end(const std::size_t cell) const { return begin(cell) + m_count[cell]; }

  // upper bound of the indices of pieces, not all of which are used
  std::size_t number_of_places() const { return m_pieces.values().size(); }
  std::size_t place(const Lattice_piece* const piece) const
  {
    return static_cast<std::size_t>(piece - m_pieces.values().data());
  }

  // difference of the indices of two cubes that are neighbors along an axis
  int stride(const int axis) const
  {
    return axis == 0 ? m_cells[1] * m_cells[2] : axis == 1 ? m_cells[2] : 1;
  }

  std::array<int, 3> coordinates(const int cell) const
  {
    return {cell / stride(0), cell / stride(1) % m_cells[1], cell % m_cells[2]};
  }

  bool has_next(const int cell, const int axis) const
  {
    return coordinates(cell)[static_cast<std::size_t>(axis)] + 1 < m_cells[axis];
  }

  int cell_of(const Eigen::Vector3d& point) const { return index(cell_coordinates(point)); }

  // in spacings from the lowest corner of the lattice
  Eigen::Vector3d in_cells(const Eigen::Vector3d& point) const
  {
    return (point - m_low) / m_spacing;
  }

  double spacing() const { return m_spacing; }
  const Eigen::Vector3d& low() const { return m_low; }

private:
  using Blocks = std::vector<std::vector<Lattice_piece>>;

  static constexpr double SAMPLES_PER_SPACING = 1.5;

  Blocks collect(const std::vector<Chord>& chords) const
  {
    const std::size_t number_of_face_blocks = number_of_blocks(m_triangles.size());
    Blocks blocks(number_of_face_blocks + number_of_blocks(chords.size()));
    for_each_block(m_triangles.size(),
                   [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
                     for(std::size_t f = begin; f < end; ++f)
                       walk_face(f, blocks[block]);
                   });
    for_each_block(chords.size(),
                   [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
                     for(std::size_t i = begin; i < end; ++i)
                       walk_chord(chords[i], blocks[number_of_face_blocks + block]);
                   });
    return blocks;
  }

  // Walks from the first corner from sample to sample, and from the last sample to each corner.
  void walk_face(const std::size_t f, std::vector<Lattice_piece>& pieces) const
  {
    const Index_triangle& t = m_triangles[f];
    const auto visit = [&](const int cell, double, double) {
      if(pieces.empty() || pieces.back().cell != cell || pieces.back().face != static_cast<int>(f))
        pieces.push_back({cell, static_cast<int>(f)});
    };
    Eigen::Vector3d last = point(t[0]);
    for_each_sample(m_points, t, m_spacing / SAMPLES_PER_SPACING, [&](const Eigen::Vector3d& p) {
      walk(last, p, visit);
      last = p;
    });
    for(const std::size_t v : t)
      walk(last, point(v), visit);
  }

  void walk_chord(const Chord& chord, std::vector<Lattice_piece>& pieces) const
  {
    walk(chord.start, chord.end, [&](const int cell, const double begin, const double end) {
      pieces.push_back(
        {cell, static_cast<int>(chord.face),
         chord.exit_vertex ? static_cast<int>(*chord.exit_vertex) : Lattice_piece::NONE,
         static_cast<float>(begin * chord.length), static_cast<float>((1 - end) * chord.length),
         static_cast<float>(chord.length)});
    });
  }

  // Calls visit(cell, begin, end) for the cubes from a to b, each a neighbor of the previous one;
  // begin and end, from 0 to 1, are the part of the segment inside it.
  template <class Function>
  void walk(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Function& visit) const
  {
    std::array<int, 3> cell = cell_coordinates(a);
    const std::array<int, 3> last = cell_coordinates(b);
    double begin = 0;
    while(true)
    {
      int axis = -1;
      double end = 1;
      for(int k = 0; k < 3; ++k)
        if(cell[k] != last[k])
        {
          const double border = m_low[k] + m_spacing * (cell[k] + (last[k] > cell[k] ? 1 : 0));
          const double t = (border - a[k]) / (b[k] - a[k]);
          if(axis < 0 || t < end)
          {
            axis = k;
            end = t;
          }
        }
      end = (std::min)((std::max)(end, begin), 1.);
      visit(index(cell), begin, axis < 0 ? 1. : end);
      if(axis < 0)
        return;
      cell[axis] += last[axis] > cell[axis] ? 1 : -1;
      begin = end;
    }
  }

  // Sorts the pieces by cube and face, and merges those with the same cube and face.
  void sort(const Blocks& blocks)
  {
    const std::size_t n = static_cast<std::size_t>(m_cells[0])
                          * static_cast<std::size_t>(m_cells[1])
                          * static_cast<std::size_t>(m_cells[2]);
    m_pieces = Buckets<Lattice_piece>(n, [&](const auto& put) {
      for(const auto& block : blocks)
        for(const Lattice_piece& piece : block)
          put(static_cast<std::size_t>(piece.cell), piece);
    });
    m_count.resize(n);
    for_each_block(n, [&](std::size_t, const std::size_t begin, const std::size_t end) {
      for(std::size_t c = begin; c < end; ++c)
        merge(c);
    });
  }

  void merge(const std::size_t cell)
  {
    const auto first = m_pieces[cell].begin(), last = m_pieces[cell].end();
    std::stable_sort(
      first, last, [](const Lattice_piece& a, const Lattice_piece& b) { return a.face < b.face; });
    auto out = first;
    for(auto in = first; in != last; ++in)
    {
      if(in == first || in->face != std::prev(out)->face)
      {
        *out++ = *in;
        continue;
      }
      Lattice_piece& piece = *std::prev(out);
      piece.depth = (std::min)(piece.depth, in->depth);
      if(in->exit_vertex != Lattice_piece::NONE && in->rest < piece.rest)
      {
        piece.rest = in->rest;
        piece.length = in->length;
        piece.exit_vertex = in->exit_vertex;
      }
    }
    m_count[cell] = static_cast<std::size_t>(without_long_chords(first, out) - first);
  }

  // Where there are short chords, far longer ones run along a limb and provide little information.
  // They are discarded.
  template <class Iterator>
  Iterator without_long_chords(const Iterator first, const Iterator last) const
  {
    float shortest = (std::numeric_limits<float>::max)();
    for(auto p = first; p != last; ++p)
      shortest = (std::min)(shortest, p->length);
    const float bound = 3 * shortest + static_cast<float>(m_spacing);
    for(auto p = first; p != last; ++p)
      if(p->depth == 0 && p->length > bound)
        *p = {p->cell, p->face};
    return std::remove_if(first, last,
                          [&](const Lattice_piece& p) { return p.depth > 0 && p.length > bound; });
  }

  std::array<int, 3> cell_coordinates(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d x = in_cells(point);
    std::array<int, 3> cell;
    for(std::size_t k = 0; k < 3; ++k)
      cell[k] = (std::min)((std::max)(static_cast<int>(x[static_cast<Eigen::Index>(k)]), 0),
                           m_cells[k] - 1);
    return cell;
  }

  int index(const std::array<int, 3>& cell) const
  {
    return (cell[0] * m_cells[1] + cell[1]) * m_cells[2] + cell[2];
  }

  Eigen::Vector3d point(const std::size_t v) const
  {
    return m_points.row(static_cast<Eigen::Index>(v));
  }

  const Row_points& m_points;
  const std::vector<Index_triangle>& m_triangles;
  double m_spacing;
  Eigen::Vector3d m_low;
  std::array<int, 3> m_cells;
  Buckets<Lattice_piece> m_pieces;  // of the cubes
  std::vector<std::size_t> m_count; // of the pieces that remain after merging
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_PIECES_H
