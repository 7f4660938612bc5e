// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SHAPE_DISTRIBUTION_D2_3_H
#define CGAL_CANONICAL_POSE_3_SHAPE_DISTRIBUTION_D2_3_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

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
  Eigen::VectorXd operator()(const Point_matrix& points, const Face_list& polygons) const;

  /// returns the shape distances of `query` to the columns of `others`: sums of absolute differences.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    return (others.colwise() - query).cwiseAbs().colwise().sum().transpose();
  }

private:
  static constexpr Eigen::Index INTERVALS = 64;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SHAPE_DISTRIBUTION_D2_3_H
