// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "described_surface.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Shape_distribution_d2_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Random.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline constexpr Eigen::Index NUMBER_OF_SAMPLES = 1024;

inline Point_matrix samples_of_surface(const Point_matrix& points,
                                       const std::vector<Index_triangle>& triangles)
{
  std::vector<double> sums;
  double sum = 0;
  for(const auto& t : triangles)
    sums.push_back(sum += twice_area(points, t));
  if(!(sum > 0))
    throw std::invalid_argument("no face has an area");
  Random random(0);
  Point_matrix result(NUMBER_OF_SAMPLES, 3);
  for(Eigen::Index i = 0; i < NUMBER_OF_SAMPLES; ++i)
  {
    // One sample per share of the area, so that descriptors of the same shape differ less.
    const double place = sum * (static_cast<double>(i) + random.get_double()) / NUMBER_OF_SAMPLES;
    const auto found = std::upper_bound(sums.begin(), sums.end() - 1, place);
    const auto& t = triangles[static_cast<std::size_t>(found - sums.begin())];
    const double root = std::sqrt(random.get_double()), v = random.get_double();
    const auto point
      = [&](const std::size_t k) { return points.row(static_cast<Eigen::Index>(t[k])); };
    result.row(i) = (1 - root) * point(0) + root * (1 - v) * point(1) + root * v * point(2);
  }
  return result;
}

} // namespace internal

Eigen::VectorXd Shape_distribution_d2_3::operator()(const Point_matrix& points,
                                                    const Face_list& polygons) const
{
  const Repaired_surface_3 surface = internal::described_surface(points, polygons);
  Point_matrix normalized = surface.points;
  internal::normalize(normalized);
  const Point_matrix samples = internal::samples_of_surface(normalized, surface.triangles);
  std::vector<double> distances;
  for(Eigen::Index j = 0; j < internal::NUMBER_OF_SAMPLES; ++j)
    for(Eigen::Index i = 0; i < j; ++i)
      distances.push_back((samples.row(i) - samples.row(j)).norm());
  const double number = static_cast<double>(distances.size());
  const double largest = 3 * std::accumulate(distances.begin(), distances.end(), 0.) / number;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(INTERVALS);
  for(const double distance : distances)
    result[(std::min)(static_cast<Eigen::Index>(INTERVALS * distance / largest), INTERVALS - 1)]
      += 1 / number;
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
