// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_COTANGENT_LAPLACIAN_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_COTANGENT_LAPLACIAN_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace Canonical_pose_benchmark {

/// The Laplacian of piecewise linear functions on a surface of area 1.
struct Cotangent_laplacian
{
  /// `triangles`: of area 0 are ignored.
  Cotangent_laplacian(const CGAL::Canonical_pose_3::Point_matrix& points,
                      const std::vector<std::array<std::size_t, 3>>& triangles)
    : stiffness(points.rows(), points.rows()), mass(Eigen::VectorXd::Zero(points.rows()))
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(const auto& t : triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto a = static_cast<int>(t[k]), p = static_cast<int>(t[(k + 1) % 3]),
                   q = static_cast<int>(t[(k + 2) % 3]);
        const Eigen::Vector3d e = points.row(p) - points.row(a), f = points.row(q) - points.row(a);
        const double twice_area = e.cross(f).norm();
        if(!(twice_area > 0))
          continue;
        mass[a] += twice_area / 6;
        const double weight = e.dot(f) / twice_area / 2;
        for(const auto& [i, j, sign] : {std::tuple(p, p, 1), {q, q, 1}, {p, q, -1}, {q, p, -1}})
          entries.emplace_back(i, j, sign * weight);
      }
    stiffness.setFromTriplets(entries.begin(), entries.end());
    area = mass.sum();
    mass /= area;
  }

  Eigen::SparseMatrix<double> stiffness; ///< symmetric, positive semidefinite
  Eigen::VectorXd mass;                  ///< with sum 1
  double area;                           ///< in the unit of the points
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_COTANGENT_LAPLACIAN_H
