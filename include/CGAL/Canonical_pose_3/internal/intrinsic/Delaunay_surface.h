// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_DELAUNAY_SURFACE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_DELAUNAY_SURFACE_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Vertex_components.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/surface/has_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Throws if no face has an area.
inline void check_some_area(const Face_corners& corners, const Point_matrix& points)
{
  if(corners.origins.empty())
    throw std::invalid_argument("the mesh is empty: it has no face");
  const auto vertex
    = [&](const std::size_t h) { return static_cast<std::size_t>(corners.origins[h]); };
  for(std::size_t h = 0; h < corners.origins.size(); h += 3)
    if(has_area(points, std::array<std::size_t, 3>{vertex(h), vertex(h + 1), vertex(h + 2)}))
      return;
  throw no_face_has_area();
}

// The intrinsic Delaunay triangulation of a surface, with nearly degenerate faces mollified, and
// with lengths around 1.
class Delaunay_surface
{
public:
  // Throws `std::invalid_argument` if no face has an area.
  Delaunay_surface(const Face_corners& corners, Point_matrix points)
    : m_exponent(normalize(points)), m_triangulation(triangulation(corners, points)),
      m_components(m_triangulation)
  {
    m_triangulation.mollify(m_components.of_vertices(), m_components.size());
    m_triangulation.flip_to_delaunay();
  }

  // lengths are in the unit of the input times 2 to this power
  int exponent() const { return m_exponent; }
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }
  const Vertex_components& components() const { return m_components; }

private:
  Intrinsic_triangulation triangulation(const Face_corners& corners, const Point_matrix& points)
  {
    check_some_area(corners, points);
    std::vector<double> lengths = side_lengths(corners, points);
    const int exponent = std::ilogb(
      Eigen::Map<const Eigen::VectorXd>(lengths.data(), static_cast<Eigen::Index>(lengths.size()))
        .mean());
    for(double& length : lengths)
      length = std::ldexp(length, -exponent);
    m_exponent += exponent;
    return {static_cast<std::size_t>(points.rows()), corners.origins, corners.twins,
            std::move(lengths)};
  }

  int m_exponent;
  Intrinsic_triangulation m_triangulation;
  Vertex_components m_components;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_DELAUNAY_SURFACE_H
