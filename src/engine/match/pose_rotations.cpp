// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pose_rotations.h"
#include "../support/Point_search.h"

#include <CGAL/Canonical_pose_3/internal/support/values_at.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

Point_matrix every(const Point_matrix& points, const Eigen::Index most)
{
  const Eigen::Index step = (std::max)(Eigen::Index(1), points.rows() / most);
  Point_matrix result((points.rows() + step - 1) / step, 3);
  for(Eigen::Index i = 0; i < result.rows(); ++i)
    result.row(i) = points.row(i * step);
  return result;
}

double mean_distance(const Point_matrix& points, const Point_search& search,
                     const Point_matrix& others)
{
  const auto nearest = search.nearest(points, 1);
  double sum = 0;
  for(std::size_t i = 0; i < nearest.size(); ++i)
    sum += (points.row(static_cast<Eigen::Index>(i))
            - others.row(static_cast<Eigen::Index>(nearest[i][0])))
             .norm();
  return sum / static_cast<double>(nearest.size());
}

} // namespace

std::vector<Pose_rotation> pose_rotations(const Matchable_data& a, const Matchable_data& b)
{
  constexpr double largest_ratio = 1.25;
  constexpr Eigen::Index number_of_points = 1000;
  const Point_matrix points = every(rows_at(a.coarse_pose, a.counted), number_of_points),
                     others = every(rows_at(b.coarse_pose, b.counted), number_of_points);
  const Point_search search_others(others);
  std::vector<Pose_rotation> result;
  std::array<Eigen::Index, 3> axes = {0, 1, 2};
  do
  {
    bool is_similar = true;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double ratio
        = a.lengths_of_axes[axes[k]] / b.lengths_of_axes[static_cast<Eigen::Index>(k)];
      is_similar = is_similar && ratio < largest_ratio && ratio > 1 / largest_ratio;
    }
    if(!is_similar && axes != std::array<Eigen::Index, 3>{0, 1, 2})
      continue;
    for(int signs = 0; signs < 8; ++signs)
    {
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
      for(std::size_t k = 0; k < 3; ++k)
        matrix(axes[k], static_cast<Eigen::Index>(k)) = (signs >> k) % 2 == 0 ? 1 : -1;
      if(matrix.determinant() < 0)
        continue;
      const Point_matrix turned = points * matrix;
      result.push_back({matrix, .5
                                  * (mean_distance(turned, search_others, others)
                                     + mean_distance(others, Point_search(turned), turned))});
    }
  } while(std::next_permutation(axes.begin(), axes.end()));
  std::stable_sort(
    result.begin(), result.end(),
    [](const Pose_rotation& r, const Pose_rotation& s) { return r.distance < s.distance; });
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
