// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SIDE_PAIRING_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SIDE_PAIRING_H

#include "label_patches.h"

#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Pairs the sides of triangles such that they form an oriented surface: each side has at most one
// twin, on the same edge and in the opposite direction once the flipped triangles are reversed.
//
// Two sides at an edge with no others are twins, and triangles connected in this way form a patch;
// a patch is cut only if it is not orientable. If an edge has more sides, those of the same patch
// are paired first, then those of patches without boundary, then the others; hence a fin is not
// connected to the surface on which it stands. If this is ambiguous, sides around the edge that
// have the inside between them become twins.
class Side_pairing
{
public:
  using Side = Corner_table::Index;

  static constexpr Side NONE = Corner_table::NONE;

  // `corners`: of triangles.
  Side_pairing(const Point_matrix& points, const Corner_table& corners)
    : m_points(points), m_corners(corners), m_twin(corners.number_of_corners(), NONE),
      m_is_flipped(corners.number_of_corners() / 3, false)
  {
    m_corners.for_each_edge([&](const Corner_table::Edge& sides) {
      if(sides.size() == 2)
        make_twins(sides[0], sides[1]);
      else if(sides.size() > 2)
        m_complex_edges.emplace_back(sides.begin(), sides.end());
    });
    find_patches();
    find_patches_with_boundary();
    for(const std::vector<std::size_t>& sides : m_complex_edges)
      pair_around(sides);
    for(std::size_t t = 0; t < m_patch.size(); ++t)
      m_is_flipped[t] = m_is_flipped[t] != is_turned(m_patch[t]);
  }

  // Twin of each side, or NONE. Side 3t+k of triangle t runs from its corner k to the next.
  const std::vector<Side>& twins() const { return m_twin; }
  bool is_flipped(const std::size_t triangle) const { return m_is_flipped[triangle]; }
  // Edges with more than two sides.
  const std::vector<std::vector<std::size_t>>& complex_edges() const { return m_complex_edges; }

private:
  struct Side_around_edge
  {
    double angle;
    std::size_t side;
    std::size_t patch;

    bool operator<(const Side_around_edge& other) const
    {
      return std::tie(angle, side) < std::tie(other.angle, other.side);
    }
  };

  void make_twins(const std::size_t a, const std::size_t b)
  {
    m_twin[a] = static_cast<Side>(b);
    m_twin[b] = static_cast<Side>(a);
  }

  // Whether the side runs from the smaller to the larger vertex in the current orientation of its
  // triangle.
  bool is_forward(const std::size_t side) const
  {
    return (m_corners.vertex(side) < m_corners.target(side)) != m_is_flipped[side / 3];
  }

  void find_patches()
  {
    const auto orient = [&](const std::size_t side, const bool is_new) {
      const std::size_t twin = m_twin[side];
      const bool fit = is_forward(side) != is_forward(twin);
      if(is_new)
        m_is_flipped[twin / 3] = !fit;
      else if(!fit)
        m_twin[side] = m_twin[twin] = NONE;
    };
    m_patch = label_patches(m_twin, orient, [&](const std::vector<std::size_t>& patch) {
      const auto flipped = std::count_if(
        patch.begin(), patch.end(), [&](const std::size_t t) -> bool { return m_is_flipped[t]; });
      if(2 * static_cast<std::size_t>(flipped) > patch.size())
        for(const std::size_t t : patch)
          m_is_flipped[t] = !m_is_flipped[t];
      m_root.push_back(m_root.size());
      m_size.push_back(patch.size());
      m_is_turned.push_back(false);
    });
  }

  void find_patches_with_boundary()
  {
    std::vector<bool> is_complex(m_twin.size(), false);
    for(const std::vector<std::size_t>& sides : m_complex_edges)
      for(const std::size_t side : sides)
        is_complex[side] = true;
    m_has_boundary.assign(m_root.size(), false);
    for(std::size_t side = 0; side < m_twin.size(); ++side)
      if(m_twin[side] == NONE && !is_complex[side])
        m_has_boundary[m_patch[side / 3]] = true;
  }

  void pair_around(const std::vector<std::size_t>& sides)
  {
    std::vector<Side_around_edge> around = sorted_around_edge(sides);
    std::stable_sort(around.begin(), around.end(),
                     [](const auto& a, const auto& b) { return a.patch < b.patch; });
    std::vector<Side_around_edge> of_closed_patches, rest;
    for(auto begin = around.begin(); begin != around.end();)
    {
      const auto end
        = std::find_if(begin, around.end(), [&](const auto& a) { return a.patch != begin->patch; });
      for(const Side_around_edge& a : without_wedges({begin, end}))
        (m_has_boundary[a.patch] ? rest : of_closed_patches).push_back(a);
      begin = end;
    }
    std::sort(of_closed_patches.begin(), of_closed_patches.end());
    of_closed_patches = without_wedges(of_closed_patches);
    rest.insert(rest.end(), of_closed_patches.begin(), of_closed_patches.end());
    std::sort(rest.begin(), rest.end());
    rest = without_wedges(rest);
    for(std::size_t i = 1; i < rest.size(); ++i) // all run in the same direction
      if(m_twin[rest[i - 1].side] == NONE)
        try_to_make_twins(rest[i - 1].side, rest[i].side);
  }

  // By the angle of the triangle, counterclockwise when looking against the edge.
  std::vector<Side_around_edge> sorted_around_edge(const std::vector<std::size_t>& sides) const
  {
    const auto point
      = [&](const std::size_t v) { return m_points.row(static_cast<Eigen::Index>(v)).transpose(); };
    const std::size_t v = m_corners.ends(sides[0]).first, w = m_corners.ends(sides[0]).second;
    const Eigen::Vector3d axis = (point(w) - point(v)).stableNormalized();
    const auto arm = [&](const std::size_t side) -> Eigen::Vector3d {
      return (point(m_corners.vertex(m_corners.next(m_corners.next(side)))) - point(v))
        .stableNormalized();
    };
    const Eigen::Vector3d x = arm(sides[0]), y = axis.cross(x);
    std::vector<Side_around_edge> result;
    for(const std::size_t side : sides)
    {
      const Eigen::Vector3d z = arm(side);
      result.push_back(
        {std::atan2(y.dot(z), x.dot(z) - x.dot(axis) * axis.dot(z)), side, m_patch[side / 3]});
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Pairs the sides that have the inside between them, like matching brackets around the edge, and
  // returns the others.
  std::vector<Side_around_edge> without_wedges(const std::vector<Side_around_edge>& around)
  {
    std::vector<std::size_t> open;
    for(std::size_t i = 0; i < 2 * around.size(); ++i)
    {
      const std::size_t side = around[i % around.size()].side;
      if(m_twin[side] != NONE)
        continue;
      const bool closes = is_forward(side) != is_turned(m_patch[side / 3]);
      while(closes && !open.empty() && m_twin[open.back()] != NONE)
        open.pop_back();
      if(closes && !open.empty())
        try_to_make_twins(open.back(), side);
      else if(!closes && i < around.size())
        open.push_back(side);
    }
    std::vector<Side_around_edge> result;
    for(const Side_around_edge& a : around)
      if(m_twin[a.side] == NONE)
        result.push_back(a);
    return result;
  }

  // Fails if the patches are already connected and one of them would have to be reversed.
  void try_to_make_twins(const std::size_t a, const std::size_t b)
  {
    std::size_t p = find(m_patch[a / 3]), q = find(m_patch[b / 3]);
    const bool fit = (is_forward(a) != is_turned(m_patch[a / 3]))
                     != (is_forward(b) != is_turned(m_patch[b / 3]));
    if(p == q && !fit)
      return;
    make_twins(a, b);
    if(p == q)
      return;
    if(m_size[p] < m_size[q])
      std::swap(p, q);
    m_size[p] += m_size[q];
    m_root[q] = p;
    m_is_turned[q] = !fit;
  }

  // Connected patches form a tree with the largest one as its root; m_is_turned is relative to the
  // parent.
  std::size_t find(std::size_t patch) const
  {
    while(m_root[patch] != patch)
      patch = m_root[patch];
    return patch;
  }

  bool is_turned(std::size_t patch) const
  {
    bool result = false;
    for(; m_root[patch] != patch; patch = m_root[patch])
      result = result != m_is_turned[patch];
    return result;
  }

  const Point_matrix& m_points;
  const Corner_table& m_corners;
  std::vector<Side> m_twin;
  std::vector<bool> m_is_flipped;
  std::vector<std::vector<std::size_t>> m_complex_edges;
  std::vector<std::size_t> m_patch; // of each triangle
  std::vector<bool> m_has_boundary; // of each patch
  std::vector<std::size_t> m_root, m_size;
  std::vector<bool> m_is_turned;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SIDE_PAIRING_H
