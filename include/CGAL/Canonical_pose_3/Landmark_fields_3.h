// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_3_H
#define CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_3_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds landmarks and the distances of all points to them.

It is returned by `front_landmarks()` and `farthest_point_landmarks()` and embedded by
`Landmark_mds_target_builder_3`. The distances may also be computed elsewhere: nothing here depends
on a mesh.

\sa `farthest_point_landmarks()`
\sa `front_landmarks()`
\sa `Landmark_mds_target_builder_3`
*/
struct Landmark_fields_3
{
  /// the \f$ l \f$ landmarks, as indices of points (of vertices in the order of `vertices(tmesh)`).
  std::vector<std::size_t> landmarks;

  /// \f$ n \times l \f$: entry \f$ (i, j) \f$ is the distance from point \f$ i \f$ to landmark
  /// \f$ j \f$, in the unit of the points.
  Eigen::MatrixXd distances;

  /// the largest distance from a point to its nearest landmark, in the unit of the points.
  double covering_radius = 0;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns landmark fields for distances that were computed elsewhere.

The landmark of a column is the first point with distance 0.

\param distances \f$ n \times l \f$, see `Landmark_fields_3::distances`; infinite in the rows of
       points that are not on a surface.

\throws std::invalid_argument if there is no column, a distance is negative or not a number, or a
       column has no distance 0; the message states row and column.

<em>Complexity:</em> linear.
*/
inline Landmark_fields_3 landmark_fields(Eigen::MatrixXd distances)
{
  if(distances.cols() == 0)
    throw std::invalid_argument("the distances have no column");
  Landmark_fields_3 fields;
  Eigen::VectorXd nearest
    = Eigen::VectorXd::Constant(distances.rows(), (std::numeric_limits<double>::infinity)());
  for(Eigen::Index j = 0; j < distances.cols(); ++j)
  {
    Eigen::Index landmark = distances.rows();
    for(Eigen::Index i = distances.rows(); i-- > 0;)
    {
      if(!(distances(i, j) >= 0))
        throw std::invalid_argument("the distance in row " + std::to_string(i) + " and column "
                                    + std::to_string(j) + " is negative or not a number");
      if(distances(i, j) == 0)
        landmark = i;
      nearest[i] = (std::min)(nearest[i], distances(i, j));
    }
    if(landmark == distances.rows())
      throw std::invalid_argument("column " + std::to_string(j)
                                  + " of the distances has no landmark: none is 0");
    fields.landmarks.push_back(static_cast<std::size_t>(landmark));
  }
  for(Eigen::Index i = 0; i < nearest.size(); ++i)
    if(std::isfinite(nearest[i]))
      fields.covering_radius = (std::max)(fields.covering_radius, nearest[i]);
  fields.distances = std::move(distances);
  return fields;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_3_H
