// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Smacof_target_builder_3.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "point_clouds.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace test_smacof_target_builder {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::euclidean_fields;
using Canonical_pose_test::largest_distance_error;
using Canonical_pose_test::random_points;
using Canonical_pose_test::relative_rms;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using CP::Smacof_target_builder_3;

Point_matrix perturbed(const Point_matrix& points, const double length)
{
  return points + length * random_points(points.rows(), 3, 11);
}

Point_matrix mirrored(const Point_matrix& points)
{
  return points * Eigen::Vector3d(1, 1, -1).asDiagonal();
}

// The weights of the documentation, without the robust factor.
class Weights
{
public:
  Weights(const CP::Landmark_fields_3& fields, const Eigen::VectorXd& weights,
          const double exponent)
    : m_shares(Eigen::VectorXd::Zero(fields.distances.cols())),
      m_largest(fields.distances.maxCoeff()), m_exponent(exponent)
  {
    for(Eigen::Index i = 0; i < weights.size(); ++i)
    {
      Eigen::Index nearest = 0;
      fields.distances.row(i).minCoeff(&nearest);
      m_shares[nearest] += weights[i] / weights.sum();
    }
    m_shares = m_shares.cwiseMax(1e-4);
  }

  double operator()(const Eigen::Index j, const double distance) const
  {
    return m_shares[j] * std::pow((std::max)(distance / m_largest, 0.02), m_exponent);
  }

  double operator()(const Eigen::Index i, const Eigen::Index j, const double distance) const
  {
    return m_shares[i] * (*this)(j, distance);
  }

private:
  Eigen::VectorXd m_shares;
  double m_largest, m_exponent;
};

// Of landmarks that are the first points.
double stress(const Point_matrix& landmarks, const CP::Landmark_fields_3& fields,
              const Weights& weights)
{
  double residuals = 0, squares = 0;
  for(Eigen::Index j = 0; j < landmarks.rows(); ++j)
    for(Eigen::Index i = 0; i < j; ++i)
    {
      const double g = fields.distances(i, j), w = weights(i, j, g);
      const double residual = (landmarks.row(i) - landmarks.row(j)).norm() - g;
      residuals += w * residual * residual;
      squares += w * g * g;
    }
  return std::sqrt(residuals / squares);
}

double point_stress(const Eigen::RowVector3d& point, const Eigen::Index i,
                    const Point_matrix& landmarks, const CP::Landmark_fields_3& fields,
                    const Weights& weights)
{
  double residuals = 0, squares = 0;
  for(Eigen::Index j = 0; j < landmarks.rows(); ++j)
  {
    const double d = fields.distances(i, j), w = weights(j, d);
    const double residual = (point - landmarks.row(j)).norm() - d;
    residuals += w * residual * residual;
    squares += w * d * d;
  }
  return std::sqrt(residuals / squares);
}

bool are_finite(const Smacof_target_builder_3& builder)
{
  return builder.targets().allFinite() && builder.landmark_targets().allFinite()
         && builder.point_stress().allFinite() && std::isfinite(builder.stress());
}

// The stress of Euclidean distances is 0 at the points and at their images under rigid motions and
// reflections only, for any weights. Near this minimum, majorization converges linearly and
// Levenberg-Marquardt quadratically, so rounding errors remain.
TEST(Smacof, recovers_a_cloud_near_its_start)
{
  const Point_matrix points = random_points(200, 3);
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 20);
  for(const double exponent : {0., 1., 2.})
    for(const double length : {0.05, 0.2})
    {
      Smacof_target_builder_3 builder(exponent);
      builder.build(fields, perturbed(points, length), uniform_weights(points));
      EXPECT_LT(relative_rms(builder.targets(), points), 1e-10);
      EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-10);
      EXPECT_LT((builder.landmark_targets() - builder.targets().topRows(20)).cwiseAbs().maxCoeff(),
                1e-10);
      EXPECT_LT(builder.stress(), 1e-10);
      EXPECT_LT(builder.point_stress().maxCoeff(), 1e-10);
      EXPECT_GT(builder.iterations(), 0);
      EXPECT_EQ(builder.length_scale(), fields.distances.maxCoeff());
    }
}

// Both mirror images have stress 0. The start decides which one is found, since the stress
// decreases: on the way to the other one, the points would be flat, with a larger stress.
TEST(Smacof, keeps_the_handedness_of_the_start)
{
  const Point_matrix points = random_points(200, 3);
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 20);
  Smacof_target_builder_3 builder;
  builder.build(fields, perturbed(mirrored(points), 0.2), uniform_weights(points));
  EXPECT_LT(relative_rms(builder.targets(), mirrored(points)), 1e-10);
  EXPECT_GT(relative_rms(builder.targets(), points), 0.1);
}

// The center of the landmarks remains that of the start, so a translation of the start moves the
// result.
TEST(Smacof, position_is_that_of_the_start)
{
  const Eigen::MatrixXd points = random_points(50, 5);
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 12);
  const Point_matrix start = points.leftCols(3);
  const Eigen::RowVector3d offset(1, -2, 3);
  Smacof_target_builder_3 builder;
  builder.build(fields, start, uniform_weights(start));
  const Point_matrix targets = builder.targets();
  EXPECT_LT((builder.landmark_targets() - start.topRows(12)).colwise().mean().norm(), 1e-12);
  builder.build(fields, start.rowwise() + offset, uniform_weights(start));
  EXPECT_LT((builder.targets() - (targets.rowwise() + offset)).cwiseAbs().maxCoeff(), 1e-9);
}

// Distances of points in five dimensions cannot be embedded in 3D. Each iteration of majorization
// decreases the weighted stress of the landmarks, from any start, also from that of classical
// scaling, which minimizes another error. The values are those of the formulas in the
// documentation, here with weights of the points that are not uniform. At its minimum, the stress
// of a point increases in every direction; the iteration may stop a little earlier.
TEST(Smacof, decreases_the_stress)
{
  const Eigen::MatrixXd points = random_points(80, 5);
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 25);
  const Eigen::VectorXd weights = random_points(80, 1, 3).array() + 1.1;
  CP::Landmark_mds_target_builder_3<> classical;
  classical.build(fields);
  const std::array<Point_matrix, 3> starts
    = {Point_matrix(classical.targets()), Point_matrix(points.leftCols(3)),
       Point_matrix(random_points(80, 3, 5))};
  for(const double exponent : {0., 1., 2.})
  {
    const Weights all(fields, weights, exponent);
    for(const Point_matrix& start : starts)
    {
      Smacof_target_builder_3 builder(exponent);
      builder.build(fields, start, weights);
      EXPECT_LT(builder.stress(), stress(start.topRows(25), fields, all));
      EXPECT_NEAR(builder.stress(), stress(builder.landmark_targets(), fields, all), 1e-12);
      for(Eigen::Index i = 0; i < 80; ++i)
      {
        const Eigen::RowVector3d point = builder.targets().row(i);
        const double value = point_stress(point, i, builder.landmark_targets(), fields, all);
        EXPECT_NEAR(builder.point_stress()[i], value, 1e-12);
        for(int k = 0; k < 6; ++k)
        {
          const Eigen::RowVector3d step
            = (k % 2 == 0 ? 0.1 : -0.1) * Eigen::RowVector3d::Unit(k / 2);
          EXPECT_GT(point_stress(point + step, i, builder.landmark_targets(), fields, all),
                    0.99 * value);
        }
      }
    }
  }
}

// Multiplying distances and start by a power of two multiplies the result by it, bit by bit.
TEST(Smacof, scales_exactly)
{
  const Eigen::MatrixXd points = random_points(50, 4);
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 12);
  const Point_matrix start = points.leftCols(3);
  Smacof_target_builder_3 expected, builder;
  expected.build(fields, start, uniform_weights(start));
  for(const int exponent : {-600, -1, 10, 600})
  {
    const double factor = std::ldexp(1., exponent);
    CP::Landmark_fields_3 scaled = fields;
    scaled.distances *= factor;
    builder.build(scaled, start * factor, uniform_weights(start));
    EXPECT_EQ(builder.targets(), expected.targets() * factor);
    EXPECT_EQ(builder.landmark_targets(), expected.landmark_targets() * factor);
    EXPECT_EQ(builder.length_scale(), expected.length_scale() * factor);
    EXPECT_EQ(builder.stress(), expected.stress());
    EXPECT_EQ(builder.point_stress(), expected.point_stress());
    EXPECT_EQ(builder.iterations(), expected.iterations());
  }
}

// A few distances are far too small: three of those between landmarks, and one of every tenth
// point, in a cube of side 2. The force of a residual r decreases like r^-3 if it is larger than
// the robust scale, so wrong distances hardly matter then, but do not vanish. With plain weights,
// they move points by a tenth and more.
TEST(Smacof, robust_weights_ignore_outliers)
{
  for(const unsigned int seed : {1u, 2u, 3u})
  {
    const Point_matrix points = random_points(200, 3, seed);
    CP::Landmark_fields_3 fields = euclidean_fields(points, 20);
    for(const auto& [i, j] : {std::array<Eigen::Index, 2>{3, 11}, {7, 16}, {1, 18}})
      fields.distances(i, j) = fields.distances(j, i) = 0.4 * fields.distances(i, j);
    for(Eigen::Index i = 20; i < 200; i += 10)
      fields.distances(i, 7 * i % 20) *= 0.5;
    Smacof_target_builder_3 plain, robust(1, 0.05);
    plain.build(fields, perturbed(points, 0.05), uniform_weights(points));
    robust.build(fields, perturbed(points, 0.05), uniform_weights(points));
    EXPECT_GT(largest_distance_error(plain.targets(), points), 0.05);
    EXPECT_LT(largest_distance_error(robust.targets(), points), 0.01);
  }
}

// Without wrong distances, robust weights have the same minimum, 0.
TEST(Smacof, robust_weights_recover_a_cloud)
{
  const Point_matrix points = random_points(100, 3);
  Smacof_target_builder_3 builder(1, 0.1);
  builder.build(euclidean_fields(points, 15), perturbed(points, 0.05), uniform_weights(points));
  EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-8);
}

// Landmarks may coincide, and the same landmark may occur twice: its distance 0 has the least
// weight. If all points start at the same position, nothing separates them, but everything is
// finite.
TEST(Smacof, coinciding_landmarks)
{
  Point_matrix points = random_points(60, 3);
  points.row(3) = points.row(7);
  points.row(20) = points.row(0);
  CP::Landmark_fields_3 fields = euclidean_fields(points, 10);
  Smacof_target_builder_3 builder;
  builder.build(fields, perturbed(points, 0.1), uniform_weights(points));
  EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-8);

  fields.landmarks.push_back(0);
  fields.distances.conservativeResize(60, 11);
  fields.distances.col(10) = fields.distances.col(0);
  builder.build(fields, perturbed(points, 0.1), uniform_weights(points));
  EXPECT_LT(largest_distance_error(builder.targets(), points), 1e-8);

  builder.build(fields, Point_matrix::Zero(60, 3), uniform_weights(points));
  EXPECT_TRUE(are_finite(builder));
}

// One landmark determines the distance from it; all distances 0 determine a point.
TEST(Smacof, of_a_single_landmark_and_of_distances_0)
{
  const Point_matrix points = random_points(6, 3), start = perturbed(points, 0.1);
  CP::Landmark_fields_3 fields = euclidean_fields(points, 1);
  Smacof_target_builder_3 builder;
  builder.build(fields, start, uniform_weights(points));
  EXPECT_TRUE(are_finite(builder));
  EXPECT_EQ(builder.stress(), 0.);
  for(Eigen::Index i = 0; i < 6; ++i)
    EXPECT_NEAR((builder.targets().row(i) - builder.landmark_targets().row(0)).norm(),
                fields.distances(i, 0), 1e-9);

  fields = euclidean_fields(points, 3);
  fields.distances.setZero();
  builder.build(fields, start, uniform_weights(points));
  EXPECT_TRUE(are_finite(builder));
  EXPECT_EQ(builder.stress(), 0.);
  EXPECT_EQ(builder.length_scale(), 0.);
  EXPECT_EQ(builder.point_stress(), Eigen::VectorXd::Zero(6));
  EXPECT_LT((builder.targets().rowwise() - builder.targets().row(0)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Smacof, bad_distances_are_named)
{
  const Point_matrix points = random_points(9, 3);
  const Eigen::VectorXd weights = uniform_weights(points);
  Smacof_target_builder_3 builder;
  CP::Landmark_fields_3 fields = euclidean_fields(points, 4);
  fields.distances(7, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THROW_WITH(builder.build(fields, points, weights), std::invalid_argument,
                    "vertex 7 to landmark 2 is not finite");
  fields.distances(7, 2) = -1;
  EXPECT_THROW_WITH(builder.build(fields, points, weights), std::invalid_argument, "negative");
  fields.distances(7, 2) = 1;
  fields.landmarks[3] = 9;
  EXPECT_THROW_WITH(builder.build(fields, points, weights), std::invalid_argument,
                    "have landmark 9, but there are 9 vertices");
  fields.landmarks.pop_back();
  EXPECT_THROW_WITH(builder.build(fields, points, weights), std::invalid_argument,
                    "have 3 landmarks, but 4 columns");
  EXPECT_THROW_WITH(builder.build(CP::Landmark_fields_3(), Point_matrix(), Eigen::VectorXd()),
                    std::invalid_argument, "have no column");
}

TEST(Smacof, what_does_not_fit_is_refused)
{
  const Point_matrix points = random_points(9, 3);
  const Eigen::VectorXd weights = uniform_weights(points);
  const CP::Landmark_fields_3 fields = euclidean_fields(points, 4);
  Smacof_target_builder_3 builder;
  EXPECT_THROW(builder.build(fields, points.topRows(8), weights), CGAL::Precondition_exception);
  EXPECT_THROW(builder.build(fields, points, weights.head(8)), CGAL::Precondition_exception);
  EXPECT_THROW(builder.build(fields, points, 0 * weights), CGAL::Precondition_exception);
  Point_matrix start = points;
  start(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(builder.build(fields, start, weights), CGAL::Precondition_exception);
  EXPECT_THROW_WITH(Smacof_target_builder_3{std::numeric_limits<double>::infinity()},
                    std::invalid_argument, "option weight_exponent is inf");
  EXPECT_THROW_WITH(Smacof_target_builder_3(1, -0.1), std::invalid_argument,
                    "option robust_scale is -0.1");
}

} // namespace test_smacof_target_builder
