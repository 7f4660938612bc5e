// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Lattice_builder.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

Lattice_body_3::Lattice_body_3(const Point_matrix& points,
                               std::vector<std::array<std::size_t, 3>> triangles,
                               const Eigen::MatrixXd& distances, const double spacing,
                               const std::vector<std::array<std::size_t, 3>>& caps)
{
  CANONICAL_POSE_3_PRECONDITION(distances.rows() == points.rows() && distances.cols() > 0);
  internal::check_elements(triangles, static_cast<std::size_t>(points.rows()));
  internal::check_elements(caps, static_cast<std::size_t>(points.rows()), "cap");
  m_data = internal::Lattice_builder(points, std::move(triangles),
                                     internal::Geodesic_bounds(distances, distances.maxCoeff()),
                                     spacing, caps)
             .take();
}

Lattice_body_3::Lattice_body_3(const Point_matrix& points,
                               std::vector<std::array<std::size_t, 3>> triangles,
                               internal::Geodesic_bounds bounds, const double spacing,
                               const std::vector<std::array<std::size_t, 3>>& caps,
                               const double share_of_cells)
  : m_data(internal::Lattice_builder(points, std::move(triangles), std::move(bounds), spacing, caps,
                                     share_of_cells)
             .take())
{}

} // namespace Canonical_pose_3
} // namespace CGAL
