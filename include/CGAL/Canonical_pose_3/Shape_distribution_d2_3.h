// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_SHAPE_DISTRIBUTION_D2_3_H
#define CGAL_CANONICAL_POSE_3_SHAPE_DISTRIBUTION_D2_3_H

#include <CGAL/Canonical_pose_3/internal/descriptors/described_surface.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Random.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief describes a shape by the distances of its points.

It contains a histogram of the distances of all pairs of 1024 random points, in 64 intervals from 0
to three times the mean distance (D2 of R. Osada et al., "Shape distributions", 2002). It depends on
the pose: for a descriptor of the shape, describe its canonical pose.

\cgalModels `ShapeDescriptor_3`

\sa `shape_descriptor()`, `Descriptor_index_3`
*/
class Shape_distribution_d2_3
{
public:
  /// returns the name, under which values are stored.
  static std::string name() { return "shape-distribution-d2"; }

  /// returns the version: values of different versions cannot be compared.
  static int version() { return 1; }

  /// returns the number of values.
  static std::size_t size() { return INTERVALS; }

  /*!
  describes a shape.

  \param points \f$ n \times 3 \f$, positions.
  \param polygons sequences of rows of `points`.

  \throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, or no face
          has an area.

  <em>Complexity:</em> \f$ O(n \log n) \f$, and half a million distances.
  */
  Eigen::VectorXd operator()(const Point_matrix& points,
                             const std::vector<std::vector<std::size_t>>& polygons) const
  {
    const Repaired_surface_3 surface = internal::described_surface(points, polygons);
    Point_matrix normalized = surface.points;
    internal::normalize(normalized);
    const Point_matrix samples = Shape_distribution_d2_3::samples(normalized, surface.triangles);
    std::vector<double> distances;
    for(Eigen::Index j = 0; j < SAMPLES; ++j)
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

  /// returns the distances of `query` to the columns of `others`: sums of absolute differences.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    return (others.colwise() - query).cwiseAbs().colwise().sum().transpose();
  }

private:
  static constexpr Eigen::Index INTERVALS = 64, SAMPLES = 1024;

  static Point_matrix samples(const Point_matrix& points,
                              const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    std::vector<double> sums;
    double sum = 0;
    for(const auto& t : triangles)
      sums.push_back(sum += internal::twice_area(points, t));
    if(!(sum > 0))
      throw std::invalid_argument("no face has an area");
    Random random(0);
    Point_matrix result(SAMPLES, 3);
    for(Eigen::Index i = 0; i < SAMPLES; ++i)
    {
      // One sample per share of the area, so that descriptors of the same shape differ less.
      const double place = sum * (static_cast<double>(i) + random.get_double()) / SAMPLES;
      const auto found = std::upper_bound(sums.begin(), sums.end() - 1, place);
      const auto& t = triangles[static_cast<std::size_t>(found - sums.begin())];
      const double root = std::sqrt(random.get_double()), v = random.get_double();
      const auto point
        = [&](const std::size_t k) { return points.row(static_cast<Eigen::Index>(t[k])); };
      result.row(i) = (1 - root) * point(0) + root * (1 - v) * point(1) + root * v * point(2);
    }
    return result;
  }
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SHAPE_DISTRIBUTION_D2_3_H
