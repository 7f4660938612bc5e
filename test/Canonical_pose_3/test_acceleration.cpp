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

#include <cstddef>

namespace test_acceleration {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using CP::Registration_summary;

// A long bar with several blocks of cells.
CP::Conforming_body_3 bar() { return Canonical_pose_test::bar_body(40, 3, 3); }

Point_matrix bent_bar_points(const double angle)
{
  return Canonical_pose_test::bar_points(40, 3, 3, angle);
}

// Bent and squeezed, to require many iterations.
Point_matrix hard_target(const double angle = 3.)
{
  return bent_bar_points(angle) * Eigen::Vector3d(0.7, 0.4, 1).asDiagonal();
}

// Inverted cells remain: to untangle them takes no iterations, but may increase the energy.
Registration_summary run(const CP::Conforming_body_3& body, const Point_matrix& target,
                         CP::Registration_options options, Point_matrix& pose,
                         CP::Spring_constraint_adaptor_3* springs = nullptr)
{
  options.injective = false;
  Registrar registrar(body, uniform_weights(body.points()), 8., options);
  if(springs != nullptr)
    registrar.add_constraint(*springs);
  registrar.set_target(target);
  pose.resize(0, 3);
  return registrar.register_to_target(pose);
}

// The same minimum in less than half the iterations (2.4 to 2.8 times fewer), for a stiff body: the
// final energy exceeds that of many uncorrected iterations by no more than the stopping tolerance
// permits, 3.5e-5 here.
TEST(Acceleration, halves_the_iterations)
{
  const CP::Conforming_body_3 body = bar();
  for(const double angle : {1., 2., 3.})
  {
    CP::Registration_options options;
    options.detail_length = 0.4;
    Point_matrix pose;
    const Registration_summary fast = run(body, hard_target(angle), options, pose);
    options.acceleration_window = 0;
    const Registration_summary plain = run(body, hard_target(angle), options, pose);
    options.number_of_iterations = 500;
    options.energy_tolerance = 0;
    const Registration_summary exact = run(body, hard_target(angle), options, pose);
    EXPECT_TRUE(fast.converged());
    EXPECT_TRUE(plain.converged());
    EXPECT_LE(2 * fast.iterations, plain.iterations);
    EXPECT_LE(fast.energy, exact.energy * (1 + 7e-5));
  }
}

// For any target, including inverted cells and springs, the energy never increases.
TEST(Acceleration, energy_never_rises)
{
  const CP::Conforming_body_3 body = bar();
  CGAL::Random random(5);
  for(int i = 0; i < 8; ++i)
  {
    CP::Registration_options options;
    options.detail_length = random.get_double(0.02, 0.5);
    options.energy_tolerance = options.move_tolerance = 0;
    options.number_of_iterations = 120;
    Point_matrix target = hard_target(random.get_double(-3., 3.));
    for(Eigen::Index k = 0; k < target.size(); ++k)
      target.data()[k] += random.get_double(-0.5, 0.5);
    if(i % 3 == 2)
      target.col(1) *= -1;
    CP::Spring_constraint_adaptor_3 springs(static_cast<std::size_t>(target.rows()));
    if(i % 2 == 1)
      springs.insert({0, static_cast<std::size_t>(target.rows()) - 1, 0.5, 0.3});
    Point_matrix pose;
    const Registration_summary summary = run(body, target, options, pose, &springs);
    EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history)) << i;
    EXPECT_EQ(summary.energy_history.size(), static_cast<std::size_t>(summary.iterations) + 1);
  }
}

// The scheme of the paper is unchanged: with a Tikhonov term or fairing, the window does not
// matter, bit by bit.
TEST(Acceleration, leaves_the_papers_scheme_alone)
{
  const CP::Conforming_body_3 body = bar();
  for(const bool is_faired : {false, true})
  {
    CP::Registration_options options;
    options.fairing_passes = is_faired ? 1 : 0;
    options.tikhonov = is_faired ? 0 : 2;
    options.number_of_iterations = 12;
    Point_matrix plain, pose;
    options.acceleration_window = 0;
    run(body, hard_target(), options, plain);
    options.acceleration_window = 5;
    run(body, hard_target(), options, pose);
    EXPECT_EQ(pose, plain);
  }
}

// The order of all sums is independent of the threads: the same bytes.
TEST(Acceleration, number_of_threads_does_not_matter)
{
  const CP::Conforming_body_3 body = bar();
  Point_matrix pose;
  const Registration_summary summary = run(body, hard_target(), {}, pose);
  Canonical_pose_test::with_each_number_of_threads([&] {
    Point_matrix again;
    EXPECT_EQ(run(body, hard_target(), {}, again).energy_history, summary.energy_history);
    EXPECT_EQ(again, pose);
  });
}

TEST(Acceleration, negative_window_is_refused)
{
  CP::Registration_options options;
  options.acceleration_window = -1;
  EXPECT_THROW_WITH(options.check(), std::invalid_argument, "acceleration_window");
}

} // namespace test_acceleration
