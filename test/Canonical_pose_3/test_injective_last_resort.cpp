// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>

#include <CGAL/Default.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"

#include <atomic>
#include <stdexcept>

namespace test_injective_last_resort {

namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;
using CP::Registration_summary;

// Refuses matrices, so that no patch can be untangled: all except that of the registration, with n
// rows, and those with at least `smallest_patch` rows. Counts the nonzeros of both kinds. A negative
// `smallest_patch`: other matrices make the solver fail.
class Refusing_factor_traits_d : public CP::Default_factor_traits_d
{
public:
  static Eigen::Index rows_of_the_registration, smallest_patch, nonzeros_of_the_registration;
  static std::atomic<Eigen::Index> nonzeros_of_patches;

  bool factor(const Matrix& matrix, NT& denominator)
  {
    const Eigen::Index rows = matrix.eigen_object().rows();
    if(rows == rows_of_the_registration)
      nonzeros_of_the_registration = matrix.eigen_object().nonZeros();
    else
      nonzeros_of_patches += matrix.eigen_object().nonZeros();
    if(rows != rows_of_the_registration && smallest_patch < 0)
      throw std::runtime_error("the solver has no license");
    return (rows == rows_of_the_registration || rows >= smallest_patch)
           && CP::Default_factor_traits_d::factor(matrix, denominator);
  }
};

Eigen::Index Refusing_factor_traits_d::rows_of_the_registration = 0;
Eigen::Index Refusing_factor_traits_d::smallest_patch = 0;
Eigen::Index Refusing_factor_traits_d::nonzeros_of_the_registration = 0;
std::atomic<Eigen::Index> Refusing_factor_traits_d::nonzeros_of_patches = 0;

CP::Conforming_body_3 bar() { return Canonical_pose_test::bar_body(8, 4, 4); }

constexpr double SOFT = .02;       // the detail length of a body that has inverted cells
constexpr double SOFTER = .002;    // ... even if it is eight times as long
constexpr double STIFF = 2 * SOFT; // without

// Registers to the mirror image of the body.
Registration_summary run(const CP::Conforming_body_3& body, const Eigen::Index smallest_patch,
                         Point_matrix& pose, const double detail_length)
{
  Refusing_factor_traits_d::rows_of_the_registration = body.points().rows();
  Refusing_factor_traits_d::smallest_patch = smallest_patch;
  Refusing_factor_traits_d::nonzeros_of_patches = 0;
  CP::Registration_options options;
  options.detail_length = detail_length;
  options.injective = true;
  CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3, CGAL::Default, Refusing_factor_traits_d>
    registrar(body, Canonical_pose_test::uniform_weights(body.points()), 8., options);
  Point_matrix target = body.points();
  target.col(1) *= -1;
  registrar.set_target(target);
  return registrar.register_to_target(pose);
}

// If no patch of a body can be untangled, nor of stiffer ones, the result is the rest pose: dividing
// lengths by 8 and multiplying by it is exact. It is not a minimum of the energy, which is reported.
TEST(Injective_last_resort, rest_pose)
{
  Point_matrix pose;
  const Registration_summary summary = run(bar(), 1 << 30, pose, SOFTER);
  EXPECT_EQ(pose, bar().points());
  EXPECT_EQ(summary.inverted, 0u);
  EXPECT_EQ(summary.termination, Registration_summary::ITERATION_LIMIT);
  ASSERT_EQ(summary.warnings.size(), 1u);
  EXPECT_NE(summary.warnings[0].find("started anew from the rest pose"), std::string::npos);
}

// If a stiffer body has no inverted cells, the result is a pose of it, whose energy is far below that
// of the rest pose. It is not a minimum for the softer body, which is reported.
TEST(Injective_last_resort, pose_of_a_stiffer_body)
{
  Point_matrix pose, stiff_pose, rest = bar().points();
  const Registration_summary summary = run(bar(), 1 << 30, pose, SOFT);
  const Registration_summary stiff = run(bar(), 1 << 30, stiff_pose, STIFF);
  EXPECT_EQ(stiff.inverted, 0u);
  EXPECT_EQ(summary.inverted, 0u);
  EXPECT_EQ(summary.termination, Registration_summary::ITERATION_LIMIT);
  EXPECT_TRUE(summary.warnings.empty());
  EXPECT_GT(summary.iterations, 0);
  const auto far_from = [&](const Point_matrix& other) { return (pose - other).norm(); };
  EXPECT_LT(far_from(stiff_pose), .1 * far_from(rest));
}

// If only the entire body can be untangled, the energy is decreased from that pose to a minimum
// without inverted cells, below that of the pose.
TEST(Injective_last_resort, minimum_from_the_pose_of_a_stiffer_body)
{
  Point_matrix pose, start;
  const Registration_summary at_start = run(bar(), 1 << 30, start, SOFT);
  const Registration_summary summary = run(bar(), 3 * bar().points().rows(), pose, SOFT);
  EXPECT_EQ(summary.inverted, 0u);
  EXPECT_TRUE(summary.converged());
  EXPECT_TRUE(summary.warnings.empty());
  EXPECT_LT(summary.energy, at_start.energy);
}

// Matrices that are not positive definite are expected, other failures are the user's.
TEST(Injective_last_resort, failures_of_the_solver_end_the_call)
{
  Point_matrix pose;
  EXPECT_THROW_WITH(run(bar(), -1, pose, SOFT), std::runtime_error, "the solver has no license");
}

// Where the minimum is far from the start, untangling ends after the work of 16 steps of the entire
// body, and as much for each of three stiffer bodies. A step has a matrix with nine times the nonzeros
// of that of the registration, and only steps of the entire body are computed here.
TEST(Injective_last_resort, is_bounded)
{
  Point_matrix pose;
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(40, 5, 5);
  const Registration_summary summary = run(body, 3 * body.points().rows(), pose, SOFTER);
  EXPECT_LE(Refusing_factor_traits_d::nonzeros_of_patches,
            4 * 16 * 9 * Refusing_factor_traits_d::nonzeros_of_the_registration);
  EXPECT_EQ(summary.termination, Registration_summary::ITERATION_LIMIT);
  EXPECT_EQ(summary.inverted, 0u);
}

} // namespace test_injective_last_resort
