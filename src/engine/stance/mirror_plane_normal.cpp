// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mirror_plane_normal.h"
#include "../support/Point_search.h"

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// How near points are to their mirror image in planes through their mean position.
class Mirror_error
{
public:
  explicit Mirror_error(const Point_matrix& points)
    : m_points(points), m_search(points),
      m_samples(points(
        Eigen::seq(0, Eigen::last, (std::max)(Eigen::Index(1), points.rows() / number_of_samples)),
        Eigen::all)),
      m_mean(points.colwise().mean())
  {}

  // The mean distance of images from the planes through the three nearest points, for the best plane with a normal near the center.
  double operator()(const Eigen::Vector3d& normal) const
  {
    double offset = 0, least = (std::numeric_limits<double>::infinity)();
    for(int pass = 0; pass < 2; ++pass)
    {
      const Eigen::VectorXd heights = ((m_samples.rowwise() - m_mean) * normal).array() - offset;
      const Point_matrix images = m_samples - 2 * heights * normal.transpose();
      const auto nearest = m_search.nearest(images, 3);
      double sum = 0, along = 0;
      for(std::size_t i = 0; i < nearest.size(); ++i)
      {
        const auto corner = [&](const std::size_t k) -> Eigen::Vector3d {
          return m_points.row(static_cast<Eigen::Index>(nearest[i][k])).transpose();
        };
        const Eigen::Vector3d plane
          = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        const double height
          = plane.dot(corner(0) - images.row(static_cast<Eigen::Index>(i)).transpose());
        sum += std::abs(height);
        along += height * plane.dot(normal);
      }
      least = (std::min)(least, sum / static_cast<double>(nearest.size()));
      offset += along / static_cast<double>(nearest.size()) / 2;
    }
    return least;
  }

private:
  static constexpr Eigen::Index number_of_samples = 150;

  const Point_matrix& m_points;
  Point_search m_search;
  Point_matrix m_samples;
  Eigen::RowVector3d m_mean;
};

} // namespace

Eigen::Vector3d mirror_plane_normal(const Point_matrix& points, const Eigen::Vector3d& left,
                                    const Eigen::Vector3d& up)
{
  constexpr double first_step = 12, last_step = 1.5, largest_turn = 84, largest_tilt = 48,
                   largest_ratio = .7;
  constexpr Eigen::Index least_number = 20;
  if(points.rows() < least_number)
    return left;
  const Mirror_error error(points);
  const Eigen::Vector3d front = left.cross(up);
  const auto turned = [&](const Eigen::Vector2d& angles) -> Eigen::Vector3d {
    const Eigen::Vector3d axis = angles[0] * up + angles[1] * front;
    return Eigen::AngleAxisd(axis.norm() * CGAL_PI / 180, axis.normalized()) * left;
  };
  Eigen::Vector2d best(0, 0);
  double least = error(left);
  std::vector<double> errors = {least};
  const auto try_out = [&](const Eigen::Vector2d& angles) {
    if(std::abs(angles[0]) > largest_turn || std::abs(angles[1]) > largest_tilt)
      return;
    errors.push_back(error(turned(angles)));
    if(errors.back() < least)
    {
      least = errors.back();
      best = angles;
    }
  };
  for(double i = -largest_turn; i <= largest_turn; i += first_step)
    for(double j = -largest_tilt; j <= largest_tilt; j += first_step)
      try_out({i, j});
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  if(!(least < largest_ratio * *middle))
    return left;
  for(double step = first_step / 2; step >= last_step; step /= 2)
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j)
        try_out(best + step * Eigen::Vector2d(i, j));
  return turned(best);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
