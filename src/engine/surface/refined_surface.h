// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_REFINED_SURFACE_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_REFINED_SURFACE_H

#include "Edge_halving.h"
#include "root_of_area.h"

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline Eigen::Vector3d corner(const Point_matrix& points, const Index_triangle& t,
                              const std::size_t k)
{
  return points.row(static_cast<Eigen::Index>(t[k % 3]));
}

// The longest edges of the triangles, averaged over the area, by the root of the area.
class Edge_length_measure
{
public:
  void add(const Point_matrix& points, const Index_triangle& t)
  {
    double longest = 0;
    for(std::size_t k = 0; k < 3; ++k)
      longest = (std::max)(longest, (corner(points, t, k) - corner(points, t, k + 1)).norm());
    const double area = twice_area(points, t) / 2;
    m_area += area;
    m_sum += area * longest;
    ++m_number;
  }

  // Whether distances cannot be measured well at the vertices alone, as without area. Surfaces of
  // some thousand vertices may have long edges in places.
  bool is_coarse() const
  {
    constexpr double length = 0.05, larger = 0.13;
    constexpr std::size_t few = 2000;
    return m_area == 0 || m_sum > (m_number < few ? length : larger) * m_area * std::sqrt(m_area);
  }

private:
  double m_area = 0, m_sum = 0;
  std::size_t m_number = 0;
};

// `points`: normalized.
inline bool is_coarse(const Point_matrix& points, const std::vector<Index_triangle>& triangles)
{
  Edge_length_measure measure;
  for(const Index_triangle& t : triangles)
    measure.add(points, t);
  return measure.is_coarse();
}

// Halves edges until there are some thousand vertices at even distances, whatever the number before:
// thin triangles must not lead to arbitrarily many. `share`: how much of that is wanted.
inline Surface_component_3 refined_surface(const Surface_component_3& surface, const double share)
{
  constexpr double fraction = 0.04, growth = 1.4142135623730951;
  const auto most
    = (std::max)(std::size_t(5000), 2 * static_cast<std::size_t>(surface.points.rows()));
  double length = fraction * root_of_area(surface.points, surface.triangles) / std::sqrt(share);
  const auto halved = [&] {
    Edge_halving result(surface.points, surface.triangles, surface.caps);
    const auto is_long
      = [&](const std::size_t a, const std::size_t b) { return result.length(a, b) > length; };
    while(result.number_of_vertices() <= most && result.halve(is_long))
      ;
    return result;
  };
  Edge_halving refined = halved();
  for(; refined.number_of_vertices() > most; refined = halved())
    length *= growth;

  Surface_component_3 result = surface;
  result.points = refined.points();
  result.triangles = refined.triangles();
  result.caps = refined.caps();
  result.added = refined.added();
  result.face_of_triangle.clear();
  for(const std::size_t parent : refined.parents())
    result.face_of_triangle.push_back(surface.face_of_triangle[parent]);
  return result;
}

// Values at the vertices of a surface, followed by interpolated ones at the vertices that were added.
template <class Matrix>
Matrix with_added(const Surface_component_3& surface, const Matrix& values)
{
  Matrix result(surface.points.rows(), values.cols());
  result.topRows(values.rows()) = values;
  const auto row = [&](const std::size_t v) { return result.row(static_cast<Eigen::Index>(v)); };
  for(const auto& [vertex, others, weights] : surface.added)
    row(vertex)
      = weights[0] * row(others[0]) + weights[1] * row(others[1]) + weights[2] * row(others[2]);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_REFINED_SURFACE_H
