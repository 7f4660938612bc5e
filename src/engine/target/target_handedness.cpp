// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "chirality.h"
#include "../surface/signed_volume.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether the enclosed volume is so small that its sign is arbitrary: within the effect of rounding
// the coordinates, or of noise in single precision on a flat sheet. `six_volumes`:
// `signed_volume()` of the triangles.
inline bool is_volume_negligible(const double six_volumes, const Point_matrix& points,
                                 const std::vector<std::array<std::size_t, 3>>& triangles)
{
  const double total = area(points, triangles);
  const double rounding = 1e-15 * points.cwiseAbs().maxCoeff();
  return !(std::abs(six_volumes) / 6 > total * (std::max)(1e-6 * std::sqrt(total), rounding));
}

} // namespace internal

Target_handedness_3 target_handedness(Point_matrix target, Point_matrix points,
                                      const std::vector<std::array<std::size_t, 3>>& triangles,
                                      const Eigen::VectorXd& weights)
{
  CANONICAL_POSE_3_PRECONDITION(target.rows() == points.rows() && weights.size() == points.rows());
  CANONICAL_POSE_3_PRECONDITION(weights.sum() > 0);
  CANONICAL_POSE_3_PRECONDITION(target.allFinite() && points.allFinite());
  internal::check_elements(triangles, static_cast<std::size_t>(points.rows()));
  const int exponent = internal::normalize(target) - internal::normalize(points);
  const double volume = internal::signed_volume(points, triangles);
  const double volume_ratio
    = internal::is_volume_negligible(volume, points, triangles)
        ? 0
        : std::ldexp(internal::signed_volume(target, triangles) / volume, 3 * exponent);
  Target_handedness_3 result;
  result.volume_ratio = std::isfinite(volume_ratio) ? volume_ratio : 0;
  result.chirality = internal::chirality(target, weights);
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
