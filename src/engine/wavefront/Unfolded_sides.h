// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_UNFOLDED_SIDES_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_UNFOLDED_SIDES_H

#include "Virtual_source.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The faces of an intrinsic triangulation, prepared for unfolding into the plane one after the
// other: for each halfedge, the data for a wave that enters the face through it.
class Unfolded_sides
{
public:
  // The halfedge runs from (0,0) to (length,0); the third corner of its face is at (apex_x,apex_y),
  // apex_y > 0.
  struct Side
  {
    double length, apex_x, apex_y;
    int origin, twin;
  };

  explicit Unfolded_sides(const Intrinsic_triangulation& triangulation)
    : m_is_flat(triangulation.number_of_vertices(), 0),
      m_sides(static_cast<std::size_t>(triangulation.number_of_halfedges()))
  {
    const std::vector<int> numbers = breadth_first_numbers(triangulation);
    const auto number = [&](int h) { return h < 0 ? h : 3 * numbers[index(h / 3)] + h % 3; };
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const auto [x, y] = triangulation.apex(h);
      m_sides[index(number(h))]
        = {triangulation.length(h), x, y, triangulation.origin(h), number(triangulation.twin(h))};
    }
    find_flat_vertices();
    m_outgoing = Buckets<int>(number_of_vertices(), [&](const auto& put) {
      for(std::size_t h = 0; h < m_sides.size(); ++h)
        put(index(m_sides[h].origin), static_cast<int>(h));
    });
  }

  std::size_t number_of_vertices() const { return m_is_flat.size(); }
  std::size_t number_of_halfedges() const { return m_sides.size(); }
  const Side& operator[](int h) const { return m_sides[index(h)]; }

  static int next(int h) { return Intrinsic_triangulation::next(h); }
  static int previous(int h) { return Intrinsic_triangulation::previous(h); }
  int target(int h) const { return (*this)[next(h)].origin; }

  // Whether the angles around the vertex sum to 360 degrees: then the surface is locally a plane,
  // and the vertex does not obstruct straight lines on either side.
  bool is_flat(int vertex) const { return m_is_flat[index(vertex)] != 0; }

  // The sides through which a wave leaves the face that it entered through h: next(h) and
  // previous(h), reversed like their twins, in the frame of h.
  Unfolded_side next_side(int h) const
  {
    const Side &side = (*this)[h], &exit = (*this)[next(h)];
    return {side.apex_x, side.apex_y, (side.length - side.apex_x) / exit.length,
            -side.apex_y / exit.length, exit.length};
  }
  Unfolded_side previous_side(int h) const
  {
    const Side &side = (*this)[h], &exit = (*this)[previous(h)];
    return {0., 0., side.apex_x / exit.length, side.apex_y / exit.length, exit.length};
  }

  bool is_border(int vertex) const { return m_is_border[index(vertex)] != 0; }

  // Calls f(h) for the halfedges that start at the vertex, in increasing order.
  template <class Function>
  void for_each_outgoing(int vertex, const Function& f) const
  {
    for(const int h : m_outgoing[index(vertex)])
      f(h);
  }

private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  // Nearby faces get similar indices, since a wave over a large surface is limited by memory
  // access.
  static std::vector<int> breadth_first_numbers(const Intrinsic_triangulation& triangulation)
  {
    std::vector<int> numbers(index(triangulation.number_of_faces()), -1), order;
    const auto visit = [&](int f) {
      if(numbers[index(f)] >= 0)
        return;
      numbers[index(f)] = static_cast<int>(order.size());
      order.push_back(f);
    };
    std::size_t done = 0;
    for(int f = 0; f < triangulation.number_of_faces(); ++f)
      for(visit(f); done < order.size(); ++done)
        for(int h = 3 * order[done], end = h + 3; h < end; ++h)
          if(!triangulation.is_border(h))
            visit(triangulation.twin(h) / 3);
    return numbers;
  }

  void find_flat_vertices()
  {
    const double pi = std::acos(-1.);
    std::vector<double> angles(m_is_flat.size(), 0.);
    for(const Side& side : m_sides)
      angles[index(side.origin)] += std::atan2(side.apex_y, side.apex_x);
    m_is_border.assign(m_is_flat.size(), 0);
    for(int h = 0; h < static_cast<int>(m_sides.size()); ++h)
      if((*this)[h].twin < 0)
        m_is_border[index((*this)[h].origin)] = m_is_border[index(target(h))] = 1;
    for(std::size_t v = 0; v < m_is_flat.size(); ++v)
      m_is_flat[v] = m_is_border[v] == 0 && std::abs(angles[v] - 2 * pi) < ANGLE_TOLERANCE ? 1 : 0;
  }

  static constexpr double ANGLE_TOLERANCE = 1e-9;

  std::vector<char> m_is_border, m_is_flat; // of each vertex
  std::vector<Side> m_sides;
  Buckets<int> m_outgoing; // the halfedges that start at each vertex
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_UNFOLDED_SIDES_H
