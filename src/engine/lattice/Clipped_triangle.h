// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_CLIPPED_TRIANGLE_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_CLIPPED_TRIANGLE_H

#include <boost/container/static_vector.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The part of a triangle between planes across two of the axes.
class Clipped_triangle
{
public:
  Clipped_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : m_corners({a, b, c})
  {}

  bool is_empty() const { return m_corners.empty(); }

  // The corners of the bounding box of the remaining part.
  Eigen::Vector3d low() const
  {
    Eigen::Vector3d result = m_corners.front();
    for(const Eigen::Vector3d& corner : m_corners)
      result = result.cwiseMin(corner);
    return result;
  }
  Eigen::Vector3d high() const
  {
    Eigen::Vector3d result = m_corners.front();
    for(const Eigen::Vector3d& corner : m_corners)
      result = result.cwiseMax(corner);
    return result;
  }

  // Clips to the range from `low` to `high`.
  void clip(const int axis, const double low, const double high)
  {
    cut(axis, low, 1);
    cut(axis, high, -1);
  }

private:
  // A plane adds one corner or, if rounding dents a sliver, up to half as many as before: 4, 6, 9,
  // 13.
  using Corners = boost::container::static_vector<Eigen::Vector3d, 13>;

  void cut(const int axis, const double border, const double sign)
  {
    Corners kept;
    for(std::size_t i = 0; i < m_corners.size(); ++i)
    {
      const Eigen::Vector3d &a = m_corners[i], &b = m_corners[(i + 1) % m_corners.size()];
      const double of_a = sign * (a[axis] - border), of_b = sign * (b[axis] - border);
      if(of_a >= 0)
        kept.push_back(a);
      if((of_a < 0) != (of_b < 0))
        kept.push_back(a + of_a / (of_a - of_b) * (b - a));
    }
    m_corners = kept;
  }

  Corners m_corners;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_CLIPPED_TRIANGLE_H
