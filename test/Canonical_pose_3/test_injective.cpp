// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"
#include "shapes.h"
#include "threads.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace test_injective {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using CP::Registration_summary;

CP::Conforming_body_3 bar() { return Canonical_pose_test::bar_body(24, 4, 4); }

// Bent so far that the inner side folds.
Point_matrix folding_target()
{
  return Canonical_pose_test::bar_points(24, 4, 4, 3.) * Eigen::Vector3d(0.6, 0.4, 1).asDiagonal();
}

// A folding target with random noise.
Point_matrix shaken_target(const unsigned int seed, const double by)
{
  CGAL::Random random(seed);
  Point_matrix target = folding_target();
  for(Eigen::Index k = 0; k < target.size(); ++k)
    target.data()[k] += by * random.get_double(-1, 1);
  return target;
}

Registration_summary run(const CP::Conforming_body_3& body, const Point_matrix& target,
                         const std::optional<bool> injective, Point_matrix& pose,
                         CP::Spring_constraint_adaptor_3* springs = nullptr)
{
  CP::Registration_options options;
  options.detail_length = 0.05;
  options.injective = injective;
  Registrar registrar(body, uniform_weights(body.points()), 8., options);
  if(springs != nullptr)
    registrar.add_constraint(*springs);
  registrar.set_target(target);
  pose.resize(0, 3);
  return registrar.register_to_target(pose);
}

// The cells that are not oriented as at rest, counted by volumes.
std::size_t number_of_inverted_cells(const CP::Conforming_body_3& body, const Point_matrix& pose)
{
  const auto volume = [](const Point_matrix& points, const std::array<int, 4>& c) {
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.row(k) = points.row(c[k + 1]) - points.row(c[0]);
    return edges.determinant();
  };
  std::size_t result = 0;
  for(const auto& cell : body.cells())
    result += volume(pose, cell) * volume(body.points(), cell) > 0 ? 0 : 1;
  return result;
}

// No inverted cell remains for a target that folds the bar, with noise, as counted by volumes. The
// bound on the energy is guaranteed.
TEST(Injective, no_cell_is_inverted)
{
  const CP::Conforming_body_3 body = bar();
  for(const double by : {0.4, 0.5, 0.6})
  {
    Point_matrix plain, pose;
    const Registration_summary before = run(body, shaken_target(1, by), false, plain);
    const Registration_summary after = run(body, shaken_target(1, by), true, pose);
    EXPECT_GT(number_of_inverted_cells(body, plain), 0u) << by;
    EXPECT_EQ(before.inverted, number_of_inverted_cells(body, plain)) << by;
    EXPECT_EQ(number_of_inverted_cells(body, pose), 0u) << by;
    EXPECT_EQ(after.inverted, 0u) << by;
    EXPECT_LE(after.energy, 1.05 * before.energy) << by;
    ASSERT_EQ(after.energy_history.size(), before.energy_history.size() + 1);
    EXPECT_TRUE(std::equal(before.energy_history.begin(), before.energy_history.end(),
                           after.energy_history.begin()));
    EXPECT_EQ(after.energy_history.back(), after.energy);
    EXPECT_TRUE(after.warnings.empty());
  }
}

// Cells are untangled by default, except with fairing, as in the paper.
TEST(Injective, is_the_default_without_fairing)
{
  const CP::Conforming_body_3 body = bar();
  Point_matrix expected, pose;
  EXPECT_EQ(run(body, shaken_target(1, 0.5), true, expected).inverted, 0u);
  run(body, shaken_target(1, 0.5), std::nullopt, pose);
  EXPECT_EQ(pose, expected);

  CP::Registration_options options;
  EXPECT_TRUE(options.is_injective());
  options.fairing_passes = 1;
  EXPECT_FALSE(options.is_injective());
  options.injective = true;
  EXPECT_TRUE(options.is_injective());
}

// The target is the mirror image: cells all over the body are inverted.
TEST(Injective, mirrored_target)
{
  const CP::Conforming_body_3 body = bar();
  Point_matrix target = body.points(), pose;
  target.col(1) *= -1;
  EXPECT_GT(run(body, target, false, pose).inverted, body.cells().size() / 10);
  EXPECT_EQ(run(body, target, true, pose).inverted, 0u);
  EXPECT_EQ(number_of_inverted_cells(body, pose), 0u);
}

// A spring has an effect while cells are untangled.
TEST(Injective, constraints_hold)
{
  const CP::Conforming_body_3 body = bar();
  CP::Spring_constraint_adaptor_3 springs(static_cast<std::size_t>(body.points().rows()));
  springs.insert({0, static_cast<std::size_t>(body.points().rows()) - 1, 0.5, 0.3});
  Point_matrix pose;
  const Registration_summary before = run(body, folding_target(), false, pose, &springs);
  const Registration_summary after = run(body, folding_target(), true, pose, &springs);
  EXPECT_GT(before.inverted, 0u);
  EXPECT_EQ(after.inverted, 0u);
  EXPECT_LE(after.energy, 1.05 * before.energy);
}

// A rigid motion of the rest pose has energy 0 and no inverted cells: the pose is the same, bit by
// bit.
TEST(Injective, nothing_changes_where_nothing_is_inverted)
{
  const CP::Conforming_body_3 body = bar();
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2., Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Point_matrix target
    = (body.points() * rotation.transpose()).rowwise() + Eigen::RowVector3d(1, 2, 3);
  Point_matrix plain, pose;
  run(body, target, false, plain);
  EXPECT_LE(run(body, target, true, pose).energy, 1e-12);
  EXPECT_EQ(pose, plain);
}

TEST(Injective, number_of_threads_does_not_matter)
{
  const CP::Conforming_body_3 body = bar();
  Point_matrix pose;
  run(body, shaken_target(1, 0.5), true, pose);
  Canonical_pose_test::with_each_number_of_threads([&] {
    Point_matrix again;
    run(body, shaken_target(1, 0.5), true, again);
    EXPECT_EQ(again, pose);
  });
}

} // namespace test_injective
