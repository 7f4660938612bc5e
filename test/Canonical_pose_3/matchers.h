// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_MATCHERS_H
#define CGAL_CANONICAL_POSE_3_TEST_MATCHERS_H

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

// The statement throws this type, and the message contains the text.
#define EXPECT_THROW_WITH(statement, exception, text)                                              \
  try                                                                                              \
  {                                                                                                \
    statement;                                                                                     \
    ADD_FAILURE() << "nothing was thrown, expected: " << (text);                                   \
  }                                                                                                \
  catch(const exception& e)                                                                        \
  {                                                                                                \
    EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << "thrown: " << e.what();      \
  }

namespace Canonical_pose_test {

using CGAL::Canonical_pose_3::Point_matrix;

inline Eigen::VectorXd uniform_weights(const Point_matrix& points)
{
  return Eigen::VectorXd::Constant(points.rows(), 1. / static_cast<double>(points.rows()));
}

inline double radius_of_gyration(const Point_matrix& points)
{
  return std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean());
}

/// root mean square distance after the best rigid motion (no reflection), divided by the mean
/// radius of gyration
inline double relative_rms(const Point_matrix& a, const Point_matrix& b)
{
  const Point_matrix moved = CGAL::Canonical_pose_3::align_target(a, b, uniform_weights(b));
  return std::sqrt((moved - b).rowwise().squaredNorm().mean())
         / (0.5 * (radius_of_gyration(a) + radius_of_gyration(b)));
}

/// mean of `relative_rms()` over all pairs
inline double mean_pairwise_rms(const std::vector<Point_matrix>& poses)
{
  double sum = 0;
  int pairs = 0;
  for(std::size_t i = 0; i < poses.size(); ++i)
    for(std::size_t j = 0; j < i; ++j, ++pairs)
      sum += relative_rms(poses[i], poses[j]);
  return pairs > 0 ? sum / pairs : 0;
}

/// the energies never increase by more than rounding errors
inline testing::AssertionResult never_rises(const std::vector<double>& energies)
{
  for(std::size_t k = 1; k < energies.size(); ++k)
    if(!(energies[k] <= energies[k - 1] * (1 + 1e-10) + 1e-24))
      return testing::AssertionFailure()
             << "iteration " << k << ": " << energies[k - 1] << " -> " << energies[k];
  return testing::AssertionSuccess();
}

template <class Array>
Point_matrix to_matrix(const Array& points)
{
  Point_matrix result(static_cast<Eigen::Index>(points.size()), 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    for(int k = 0; k < 3; ++k)
      result(static_cast<Eigen::Index>(i), k) = points[i][k];
  return result;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_MATCHERS_H
