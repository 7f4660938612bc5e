// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_CHECK_UNFOLDABLE_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_CHECK_UNFOLDABLE_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The size of the connected component of each vertex: the longest side of its bounding box.
inline std::vector<double> sizes_of_components(const std::vector<int>& origins,
                                               const Point_matrix& points)
{
  const auto n = static_cast<std::size_t>(points.rows());
  const auto row = [&](const std::size_t h) { return static_cast<std::size_t>(origins[h]); };
  Disjoint_sets components(n);
  for(std::size_t h = 0; h < origins.size(); h += 3)
    for(const std::size_t k : {h + 1, h + 2})
      components.unite(row(h), row(k));
  Point_matrix least = points, largest = points;
  std::vector<Eigen::Index> component(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const Eigen::Index c = component[i] = static_cast<Eigen::Index>(components.representative(i));
    const Eigen::RowVector3d point = points.row(static_cast<Eigen::Index>(i));
    least.row(c) = least.row(c).cwiseMin(point).eval();
    largest.row(c) = largest.row(c).cwiseMax(point).eval();
  }
  std::vector<double> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[i] = (largest.row(component[i]) - least.row(component[i])).maxCoeff();
  return result;
}

// Throws a `Face_defect` with the first face that CGAL's shortest paths cannot unfold: they become
// infinite, or terminate the program, if heights or sizes differ by a factor of more than about
// 1e15 (determined experimentally), and squares of squared lengths must not vanish. `points`:
// normalized.
inline void check_unfoldable(const Face_corners& corners, const Point_matrix& points)
{
  constexpr double least_height = 1e-14, least_size = 1e-14, least_length = 1e-60;
  const auto refuse_if = [](const bool condition, const std::size_t h, const char* defect) {
    if(condition)
      throw Face_defect(h / 3, std::string("is too ") + defect);
  };
  const std::vector<double> sizes = sizes_of_components(corners.origins, points);
  for(std::size_t h = 0; h < corners.origins.size(); h += 3)
  {
    const auto corner = [&](const std::size_t k) -> Eigen::RowVector3d {
      return points.row(corners.origins[h + k]);
    };
    const Eigen::RowVector3d e = corner(1) - corner(0), f = corner(2) - corner(0);
    const double length = (std::max)({e.stableNorm(), f.stableNorm(), (f - e).stableNorm()});
    refuse_if(
      !(length >= least_length), h,
      "small for exact distances: its edges are shorter than 1e-60 times the largest coordinate");
    refuse_if(!(length >= least_size * sizes[static_cast<std::size_t>(corners.origins[h])]), h,
              "small for exact distances: its edges are shorter than 1e-14 times the surface");
    refuse_if(!((e / length).cross(f / length).norm() >= least_height), h,
              "thin for exact distances: its height is less than 1e-14 times its longest edge");
  }
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_CHECK_UNFOLDABLE_H
