// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_LOOP_TRIANGULATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_LOOP_TRIANGULATION_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Fills a closed polygon of rows of `points` with triangles with the same rows and orientation: of
// minimal area up to this many corners; in a longer polygon, ears are first cut off along the
// shortest diagonal. O(n log n) for n corners.
class Loop_triangulation
{
public:
  static constexpr std::size_t MAXIMUM_FOR_LEAST_AREA = 64;

  Loop_triangulation(const Point_matrix& points, std::vector<std::size_t> loop)
    : m_points(points), m_loop(std::move(loop))
  {}

  // Appends the triangles.
  void run(std::vector<Index_triangle>& triangles)
  {
    if(m_loop.size() > MAXIMUM_FOR_LEAST_AREA)
      cut_ears(triangles);
    if(m_loop.size() >= 3)
      fill_with_least_area(triangles);
  }

private:
  auto point(const std::size_t i) const
  {
    return m_points.row(static_cast<Eigen::Index>(m_loop[i]));
  }

  void cut_ears(std::vector<Index_triangle>& triangles)
  {
    const std::size_t n = m_loop.size();
    using Ear = std::tuple<double, std::size_t, std::size_t, std::size_t>; // diagonal, corners
    std::priority_queue<Ear, std::vector<Ear>, std::greater<Ear>> ears;
    std::vector<std::size_t> previous(n), next(n);
    const auto push = [&](const std::size_t i) {
      ears.emplace((point(next[i]) - point(previous[i])).squaredNorm(), i, previous[i], next[i]);
    };
    for(std::size_t i = 0; i < n; ++i)
    {
      previous[i] = (i + n - 1) % n;
      next[i] = (i + 1) % n;
    }
    for(std::size_t i = 0; i < n; ++i)
      push(i);
    std::vector<bool> is_cut(n, false);
    for(std::size_t left = n; left > MAXIMUM_FOR_LEAST_AREA; ears.pop())
    {
      const std::size_t i = std::get<1>(ears.top()), p = std::get<2>(ears.top()),
                        q = std::get<3>(ears.top());
      if(is_cut[i] || previous[i] != p || next[i] != q)
        continue;
      triangles.push_back({m_loop[p], m_loop[i], m_loop[q]});
      is_cut[i] = true;
      next[p] = q;
      previous[q] = p;
      push(p);
      push(q);
      --left;
    }
    std::vector<std::size_t> rest;
    for(std::size_t i = 0; i < n; ++i)
      if(!is_cut[i])
        rest.push_back(m_loop[i]);
    m_loop.swap(rest);
  }

  // Of triangulations with nearly the same area (planar polygons have many), prefer short edges.
  double cost(const std::size_t i, const std::size_t j, const std::size_t k) const
  {
    const Eigen::Vector3d a = point(j) - point(i), b = point(k) - point(i);
    return a.cross(b).norm() + 0.01 * (a.squaredNorm() + b.squaredNorm() + (a - b).squaredNorm());
  }

  void fill_with_least_area(std::vector<Index_triangle>& triangles) const
  {
    const std::size_t n = m_loop.size();
    std::vector<double> least(n * n, 0); // cost of the corners i to k, closed by side ik
    std::vector<std::size_t> apex(n * n, 0);
    for(std::size_t length = 2; length < n; ++length)
      for(std::size_t i = 0, k = length; k < n; ++i, ++k)
      {
        least[i * n + k] = std::numeric_limits<double>::infinity();
        apex[i * n + k] = i + 1; // even if no cost is finite
        for(std::size_t j = i + 1; j < k; ++j)
        {
          const double sum = least[i * n + j] + least[j * n + k] + cost(i, j, k);
          if(sum < least[i * n + k])
          {
            least[i * n + k] = sum;
            apex[i * n + k] = j;
          }
        }
      }
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, n - 1}};
    while(!open.empty())
    {
      const auto [i, k] = open.back();
      open.pop_back();
      if(k - i < 2)
        continue;
      const std::size_t j = apex[i * n + k];
      triangles.push_back({m_loop[i], m_loop[j], m_loop[k]});
      open.emplace_back(j, k);
      open.emplace_back(i, j);
    }
  }

  const Point_matrix& m_points;
  std::vector<std::size_t> m_loop;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_LOOP_TRIANGULATION_H
