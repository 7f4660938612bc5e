// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_COMPONENT_ORIENTER_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_COMPONENT_ORIENTER_H

#include "Manifold_builder.h"
#include "label_patches.h"

#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/Loop_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
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

// Finds the components of an oriented 2-manifold, closes its holes, and orients it outward.
class Component_orienter
{
public:
  using Side = Manifold_builder::Side;

  // `points`: normalized, rows of `surface.origins`. `twins`: see Manifold_builder::twins().
  Component_orienter(const Point_matrix& points, const std::vector<Side>& twins,
                     Repaired_surface_3& surface)
    : m_points(points), m_twins(twins), m_surface(surface)
  {}

  void run()
  {
    find_components();
    fill_holes();
    orient_outwards();
  }

private:
  static constexpr std::size_t NONE = Manifold_builder::NONE;

  Eigen::Vector3d point(const std::size_t v) const
  {
    return m_points.row(static_cast<Eigen::Index>(v));
  }

  std::size_t vertex(const std::size_t c) const { return m_surface.triangles[c / 3][c % 3]; }

  void find_components()
  {
    using Rank = std::tuple<double, std::size_t, std::size_t>; // -area, smallest vertex, component
    std::vector<Rank> ranks;
    // Areas of equal components may differ by rounding, since the sum depends on the traversal
    // order.
    const auto rank = [&](const std::vector<std::size_t>& triangles) {
      double area = 0;
      std::size_t smallest = NONE;
      for(const std::size_t t : triangles)
      {
        const Index_triangle& corners = m_surface.triangles[t];
        area += twice_area(m_points, corners);
        smallest = (std::min)(smallest, *std::min_element(corners.begin(), corners.end()));
      }
      ranks.emplace_back(-area, smallest, ranks.size());
    };
    m_surface.component_of_triangle = label_patches(
      m_twins, [](std::size_t, bool) {}, rank);
    std::sort(ranks.begin(), ranks.end());
    std::vector<std::size_t> number(ranks.size());
    for(std::size_t i = 0; i < ranks.size(); ++i)
    {
      number[std::get<2>(ranks[i])] = i;
      m_double_area.push_back(-std::get<0>(ranks[i]));
    }
    for(std::size_t& c : m_surface.component_of_triangle)
      c = number[c];
    m_surface.number_of_components = ranks.size();
  }

  void fill_holes()
  {
    std::vector<std::size_t> leaving(m_surface.origins.size(), NONE); // sides without a twin
    for(std::size_t side = 0; side < m_twins.size(); ++side)
      if(m_twins[side] == NONE)
        leaving[vertex(side)] = side;
    for(std::size_t first = 0; first < leaving.size(); ++first)
    {
      std::vector<std::size_t> loop;
      const std::size_t side = leaving[first];
      for(std::size_t v = first; leaving[v] != NONE;)
      {
        loop.push_back(v);
        v = vertex(Manifold_builder::next(std::exchange(leaving[v], NONE)));
      }
      if(loop.empty())
        continue;
      std::reverse(loop.begin(), loop.end());
      Loop_triangulation(m_points, std::move(loop)).run(m_surface.caps);
      m_component_of_cap.resize(m_surface.caps.size(), m_surface.component_of_triangle[side / 3]);
    }
  }

  // Volumes that are only rounding errors, as for flat sheets, have no effect.
  void orient_outwards()
  {
    const std::size_t n = m_surface.number_of_components;
    std::vector<std::size_t> center(n, NONE);
    std::vector<double> volume(n, 0); // six times the volume
    const auto add = [&](const std::vector<Index_triangle>& triangles,
                         const std::vector<std::size_t>& component) {
      for(std::size_t t = 0; t < triangles.size(); ++t)
      {
        std::size_t& c = center[component[t]];
        if(c == NONE)
          c = triangles[t][0];
        const Eigen::Vector3d o = point(c);
        volume[component[t]]
          += (point(triangles[t][0]) - o)
               .dot((point(triangles[t][1]) - o).cross(point(triangles[t][2]) - o));
      }
    };
    add(m_surface.triangles, m_surface.component_of_triangle);
    add(m_surface.caps, m_component_of_cap);
    std::vector<bool> is_inside_out(n);
    for(std::size_t c = 0; c < n; ++c)
      is_inside_out[c] = volume[c] < -1e-10 * std::pow(m_double_area[c], 1.5);
    const auto turn_over
      = [&](std::vector<Index_triangle>& triangles, const std::vector<std::size_t>& component) {
          for(std::size_t t = 0; t < triangles.size(); ++t)
            if(is_inside_out[component[t]])
              std::swap(triangles[t][1], triangles[t][2]);
        };
    turn_over(m_surface.triangles, m_surface.component_of_triangle);
    turn_over(m_surface.caps, m_component_of_cap);
  }

  const Point_matrix& m_points;
  const std::vector<Side>& m_twins;
  Repaired_surface_3& m_surface;
  std::vector<double> m_double_area; // of each component
  std::vector<std::size_t> m_component_of_cap;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_COMPONENT_ORIENTER_H
