// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_POINT_CLOUDS_H
#define CGAL_CANONICAL_POSE_3_TEST_POINT_CLOUDS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Random.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Canonical_pose_test {

// The corner of a box with three different edges: no reflection maps it to itself.
inline CGAL::Canonical_pose_3::Point_matrix corner()
{
  CGAL::Canonical_pose_3::Point_matrix points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3;
  return points;
}

inline CGAL::Canonical_pose_3::Point_matrix mirrored(CGAL::Canonical_pose_3::Point_matrix points)
{
  points.col(1) *= -1;
  return points;
}

// Moved and turned, differently for each i.
inline CGAL::Canonical_pose_3::Point_matrix moved(const CGAL::Canonical_pose_3::Point_matrix& points,
                                                   const int i)
{
  const Eigen::Matrix3d turn
    = Eigen::AngleAxisd(0.7 * i, Eigen::Vector3d(1, 2, i - 1).normalized()).toRotationMatrix();
  return (points * turn.transpose()).rowwise() + Eigen::RowVector3d(i, -3, 1);
}

inline Eigen::MatrixXd random_points(const Eigen::Index n, const Eigen::Index dimension,
                                     const unsigned int seed = 7)
{
  CGAL::Random random(seed);
  Eigen::MatrixXd points(n, dimension);
  for(Eigen::Index i = 0; i < n; ++i)
    for(Eigen::Index k = 0; k < dimension; ++k)
      points(i, k) = random.get_double(-1., 1.);
  return points;
}

// The first points are the landmarks.
inline CGAL::Canonical_pose_3::Landmark_fields_3 euclidean_fields(const Eigen::MatrixXd& points,
                                                                  const Eigen::Index l)
{
  CGAL::Canonical_pose_3::Landmark_fields_3 fields;
  fields.distances.resize(points.rows(), l);
  for(Eigen::Index j = 0; j < l; ++j)
  {
    fields.landmarks.push_back(static_cast<std::size_t>(j));
    fields.distances.col(j) = (points.rowwise() - points.row(j)).rowwise().norm();
  }
  return fields;
}

inline double largest_distance_error(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  double error = 0;
  for(Eigen::Index i = 0; i < a.rows(); ++i)
    for(Eigen::Index j = 0; j < i; ++j)
      error
        = (std::max)(error, std::abs((a.row(i) - a.row(j)).norm() - (b.row(i) - b.row(j)).norm()));
  return error;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_POINT_CLOUDS_H
