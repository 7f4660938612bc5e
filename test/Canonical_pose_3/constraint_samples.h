// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_CONSTRAINT_SAMPLES_H
#define CGAL_CANONICAL_POSE_3_TEST_CONSTRAINT_SAMPLES_H

#include <CGAL/Canonical_pose_3/Direction_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Symmetry_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

// Constraints of each kind on a handful of points, and their matrices.
namespace Canonical_pose_test {

namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;
using Eigen::RowVector3d;

constexpr int number_of_points = 8;

inline CP::Spring_constraint_adaptor_3 springs()
{
  CP::Spring_constraint_adaptor_3 result(number_of_points);
  result.insert({0, 1, 0.7, 2.});
  result.insert({2, 1, 3., 0.3});
  return result;
}

inline CP::Direction_constraint_adaptor_3 directions()
{
  CP::Direction_constraint_adaptor_3 result(number_of_points);
  result.insert({0, 1, RowVector3d(1, 2, 3), 2.});
  result.insert({2, 1, RowVector3d(0, 0, -1), 0.3});
  return result;
}

inline CP::Handle_constraint_adaptor_3 handles()
{
  CP::Handle_constraint_adaptor_3 result(number_of_points);
  result.insert({5, RowVector3d(1, 2, 3), 2.});
  result.insert({1, RowVector3d(0, 0, -1), 0.3});
  return result;
}

inline CP::Symmetry_constraint_adaptor_3 symmetry()
{
  CP::Symmetry_constraint_adaptor_3 result(number_of_points);
  for(std::size_t i = 0; i < 3; ++i)
    result.insert({i, i + 4, 0.5 + double(i)});
  result.insert({3, 3, 0.7});
  return result;
}

template <class Constraint>
Eigen::MatrixXd matrix_of(const Constraint& constraint)
{
  std::vector<Eigen::Triplet<double>> entries;
  constraint.add_to_matrix(entries);
  Eigen::SparseMatrix<double> matrix(number_of_points, number_of_points);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <class Constraint>
Point_matrix right_hand_side_of(Constraint& constraint, const Point_matrix& points)
{
  Point_matrix result = Point_matrix::Zero(number_of_points, 3);
  constraint.add_to_right_hand_side(points, result);
  return result;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_CONSTRAINT_SAMPLES_H
