// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>

#include <gtest/gtest.h>

#include "conforming_bar.h"
#include "matchers.h"
#include "registrar.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

namespace test_visitor {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Registrar;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;
using CP::Registration_progress;
using CP::Registration_summary;

const double length_scale = 8;

// Has only the requirements of the concept RegistrationVisitor_3.
class Visitor_archetype
{
public:
  explicit Visitor_archetype(const int last) : m_last(last) {}
  Visitor_archetype(const Visitor_archetype&) = default;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;

  bool operator()(const Registration_progress& progress) { return progress.iteration < m_last; }

private:
  int m_last;
};

// A bar to be bent, with a spring. Inverted cells remain: to untangle them is no iteration, and no
// visitor sees it.
class Visitor : public testing::Test
{
protected:
  Visitor()
    : m_body(Canonical_pose_test::conforming_bar(0.)),
      m_target(Canonical_pose_test::conforming_bar(2.).points()
               * Eigen::Vector3d(0.7, 0.4, 1).asDiagonal()),
      m_springs(static_cast<std::size_t>(m_target.rows()))
  {
    m_springs.insert({0, 12, 2., 0.1});
  }

  std::unique_ptr<Registrar> registrar(CP::Registration_options options) const
  {
    options.injective = false;
    auto result
      = std::make_unique<Registrar>(m_body, uniform_weights(m_target), length_scale, options);
    result->set_target(m_target);
    return result;
  }

  CP::Conforming_body_3 m_body;
  Point_matrix m_target;
  CP::Spring_constraint_adaptor_3 m_springs;
};

// Stopping after iteration k must be the same as allowing k iterations, bit by bit, since a visitor
// only observes; the energies passed to it are those of the summary. With fairing, the energy may
// increase: then the result is the iterate of least energy, as if fewer iterations were allowed.
TEST_F(Visitor, stops_where_the_cap_would)
{
  for(const int fairing_passes : {0, 1})
    for(const int k : {1, 2, 7})
    {
      CP::Registration_options options;
      options.fairing_passes = fairing_passes;
      options.energy_tolerance = options.move_tolerance = 0;
      Point_matrix stopped, capped;
      const Registration_summary summary
        = registrar(options)->register_to_target(stopped, Visitor_archetype(k));
      options.number_of_iterations = k;
      const Registration_summary expected = registrar(options)->register_to_target(capped);
      EXPECT_EQ(summary.termination, Registration_summary::CANCELED);
      EXPECT_EQ(expected.termination, Registration_summary::ITERATION_LIMIT);
      EXPECT_EQ(summary.iterations, k);
      EXPECT_EQ(summary.energy_history, expected.energy_history);
      EXPECT_TRUE(summary.is_usable());
      EXPECT_FALSE(summary.converged());
      EXPECT_EQ(summary.brief_report().find("canceled after "), 0u);
      const std::vector<double>& energies = expected.energy_history;
      const auto least = std::min_element(energies.begin(), energies.end());
      options.number_of_iterations = static_cast<int>(least - energies.begin());
      if(fairing_passes == 0)
      {
        EXPECT_EQ(options.number_of_iterations, k);
      }
      capped.resize(0, 3);
      registrar(options)->register_to_target(capped);
      EXPECT_EQ(summary.energy, *least);
      EXPECT_EQ(stopped, capped);
    }
}

// One call per iteration, with the values of that iteration; a visitor that never stops changes
// nothing. Convergence means that no surface vertex moved by more than the tolerance; without
// acceleration, this is the move of the last iteration.
TEST_F(Visitor, sees_every_iteration_once)
{
  CP::Registration_options options;
  options.acceleration_window = 0;
  std::vector<Registration_progress> seen;
  const auto watched = registrar(options), alone = registrar(options);
  watched->add_constraint(m_springs);
  alone->add_constraint(m_springs);
  Point_matrix pose, expected;
  const Registration_summary summary
    = watched->register_to_target(pose, [&](const Registration_progress& progress) {
        seen.push_back(progress);
        return true;
      });
  EXPECT_TRUE(alone->register_to_target(expected).converged());
  EXPECT_EQ(pose, expected);
  ASSERT_EQ(seen.size(), static_cast<std::size_t>(summary.iterations));
  ASSERT_GT(seen.size(), 2u);
  for(std::size_t i = 0; i < seen.size(); ++i)
  {
    EXPECT_EQ(seen[i].iteration, static_cast<int>(i) + 1);
    EXPECT_EQ(seen[i].energy, summary.energy_history[i + 1]);
    EXPECT_EQ(seen[i].energy,
              seen[i].energy_match + seen[i].energy_arap + seen[i].energy_constraints);
    EXPECT_GT(seen[i].energy_constraints, 0);
  }
  EXPECT_LE(seen.back().largest_move, options.move_tolerance);
  EXPECT_EQ(seen.back().energy_arap, summary.energy_arap);
}

// The reported move is the difference of the poses with two different iteration limits.
TEST_F(Visitor, largest_move_is_that_of_the_surface)
{
  CP::Registration_options options;
  Registration_progress last = {};
  Point_matrix before, after;
  options.number_of_iterations = 3;
  registrar(options)->register_to_target(before);
  options.number_of_iterations = 4;
  registrar(options)->register_to_target(after, [&](const Registration_progress& progress) {
    last = progress;
    return true;
  });
  const double move = (after - before).rowwise().norm().maxCoeff() / length_scale;
  EXPECT_GT(move, 1e-4);
  EXPECT_NEAR(last.largest_move, move, 1e-12);
}

// Exceptions of a visitor propagate, the points are unchanged, and the registrar can still be used.
TEST_F(Visitor, exception_passes_through)
{
  const auto throwing = registrar({}), fresh = registrar({});
  const Point_matrix start = m_target.rowwise() + Eigen::RowVector3d(1, 2, 3);
  Point_matrix points = start, expected = start;
  EXPECT_THROW_WITH(throwing->register_to_target(points,
                                                 [](const Registration_progress& progress) {
                                                   if(progress.iteration == 3)
                                                     throw std::runtime_error("enough");
                                                   return true;
                                                 }),
                    std::runtime_error, "enough");
  EXPECT_EQ(points, start);
  throwing->register_to_target(points);
  fresh->register_to_target(expected);
  EXPECT_EQ(points, expected);
}

// If the iteration has converged, this takes precedence over a request to stop; a visitor is not
// called if there is no iteration.
TEST_F(Visitor, convergence_and_empty_runs)
{
  m_target = m_body.points();
  Point_matrix pose;
  CP::Registration_options options;
  options.energy_tolerance = options.move_tolerance = 1;
  int calls = 0;
  const auto count = [&](const Registration_progress&) {
    ++calls;
    return false;
  };
  EXPECT_TRUE(registrar(options)->register_to_target(pose, count).converged());
  EXPECT_EQ(calls, 1);
  options.number_of_iterations = 0;
  pose.resize(0, 3);
  EXPECT_TRUE(registrar(options)->register_to_target(pose, count).is_usable());
  EXPECT_EQ(calls, 1);
}

} // namespace test_visitor
