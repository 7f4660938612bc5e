// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_FOLLOWING_CANDIDATE_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_FOLLOWING_CANDIDATE_H

#include "joined_triangles.h"

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_tree.h>
#include <CGAL/Canonical_pose_3/internal/surface/has_area.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// An upper bound that is at most twice the diameter.
inline double diameter_of(const Point_matrix& points)
{
  const Eigen::RowVector3d center = points.colwise().mean();
  return 2 * (points.rowwise() - center).rowwise().norm().maxCoeff();
}

// Points that are uniformly distributed over a surface: samples of the area, then the vertices, unless
// there are more of them.
inline Point_matrix points_on_surface(const Point_matrix& points,
                                      const std::vector<Index_triangle>& triangles,
                                      const std::size_t number)
{
  std::vector<double> sums;
  double sum = 0;
  Point_matrix normalized = points;
  normalize(normalized);
  for(const Index_triangle& t : triangles)
    sums.push_back(sum += twice_area(normalized, t));
  const std::size_t number_of_vertices = static_cast<std::size_t>(points.rows());
  Point_matrix result(
    static_cast<Eigen::Index>(number + (number_of_vertices > number ? 0 : number_of_vertices)), 3);
  for(std::size_t i = 0; i < number; ++i)
  {
    const double position = (static_cast<double>(i) + .5) / static_cast<double>(number);
    const auto found = std::upper_bound(sums.begin(), sums.end() - 1, position * sum);
    const Index_triangle& t = triangles[static_cast<std::size_t>(found - sums.begin())];
    // a sequence of low discrepancy in the unit square
    double ignored;
    double x = std::modf(static_cast<double>(i) * 0.7548776662466927, &ignored);
    double y = std::modf(static_cast<double>(i) * 0.5698402909980532, &ignored);
    if(x + y > 1)
    {
      x = 1 - x;
      y = 1 - y;
    }
    result.row(static_cast<Eigen::Index>(i))
      = (1 - x - y) * points.row(static_cast<Eigen::Index>(t[0]))
        + x * points.row(static_cast<Eigen::Index>(t[1]))
        + y * points.row(static_cast<Eigen::Index>(t[2]));
  }
  if(number_of_vertices <= number)
    result.bottomRows(points.rows()) = points;
  return result;
}

// Tells how near points are to components, and whether they are inside.
class Component_neighborhood
{
public:
  Component_neighborhood(const std::vector<Surface_component_3>& components,
                         const std::vector<std::size_t>& indices)
    : Component_neighborhood(joined_triangles(components, indices))
  {}

  double distance(const Eigen::RowVector3d& point) const { return m_surface.distance(point); }

  // Caps close the holes.
  bool surrounds(const Eigen::RowVector3d& point) const
  {
    return m_surface.winding_number(point) + (m_caps ? m_caps->winding_number(point) : 0) != 0;
  }

private:
  explicit Component_neighborhood(const Joined_triangles& joined)
    : m_surface(joined.points, joined.triangles)
  {
    Point_matrix points = joined.points;
    normalize(points);
    if(has_area(points, joined.caps))
      m_caps.emplace(joined.points, joined.caps);
  }

  Triangle_tree m_surface;
  std::optional<Triangle_tree> m_caps;
};

// A component that may follow those around it.
class Following_candidate
{
public:
  Following_candidate() = default;
  Following_candidate(const Surface_component_3& surface, const std::size_t number_of_samples)
    : m_diameter(diameter_of(surface.points)),
      m_points(points_on_surface(surface.points, surface.triangles, number_of_samples)),
      m_distances(static_cast<std::size_t>(m_points.rows()),
                  std::numeric_limits<double>::infinity()),
      m_is_inside(number_of_samples, 0)
  {}

  void approach(const Component_neighborhood& neighborhood)
  {
    for(std::size_t i = 0; i < m_distances.size(); ++i)
    {
      const Eigen::RowVector3d point = m_points.row(static_cast<Eigen::Index>(i));
      m_distances[i] = (std::min)(m_distances[i], neighborhood.distance(point));
      if(i < m_is_inside.size() && neighborhood.surrounds(point))
        m_is_inside[i] = 1;
    }
  }

  bool is_in_touch() const
  {
    return std::any_of(m_distances.begin(), m_distances.end(),
                       [&](const double distance) { return is_close(distance); });
  }

  double share_in_touch() const
  {
    const auto number = static_cast<std::ptrdiff_t>(m_is_inside.size());
    return static_cast<double>(
             std::count_if(m_distances.begin(), m_distances.begin() + number,
                           [&](const double distance) { return is_close(distance); }))
           / static_cast<double>(number);
  }

  // Half of the area is farther away than that.
  double median_distance() const
  {
    std::vector<double> distances(
      m_distances.begin(), m_distances.begin() + static_cast<std::ptrdiff_t>(m_is_inside.size()));
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
  }

  double least_distance() const
  {
    return *std::min_element(m_distances.begin(), m_distances.end());
  }

  double diameter() const { return m_diameter; }

  double share_inside() const
  {
    return static_cast<double>(std::count(m_is_inside.begin(), m_is_inside.end(), 1))
           / static_cast<double>(m_is_inside.size());
  }

private:
  static constexpr double CLOSENESS = .05; // of the diameter

  bool is_close(const double distance) const { return distance <= CLOSENESS * m_diameter; }

  double m_diameter = 0;
  Point_matrix m_points;
  std::vector<double> m_distances;
  std::vector<char> m_is_inside; // samples of the area
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_FOLLOWING_CANDIDATE_H
