// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which image of the target is chosen after the rounds does not depend on the one they start from; a body that
// collapses to a target that is inside out is registered twice more, exactly as with larger detail lengths; one of
// both is kept.
// A person is decided by chirality, an animal by volume.
#include "../../examples/Canonical_pose_3/Articulated_animal.h"
#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <gtest/gtest.h>

#include "matchers.h"

#include <algorithm>
#include <string>
#include <vector>

namespace test_rounds {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_examples::Articulated_figure;

// The steps before the registration of a figure in one of its poses.
class Steps
{
public:
  template <class Shape>
  static Steps of(const std::size_t pose)
  {
    static const Shape shape(2000);
    std::vector<std::vector<std::size_t>> faces;
    for(const auto& t : shape.triangles())
      faces.emplace_back(t.begin(), t.end());
    return Steps(CP::prepare_surface(
      Canonical_pose_test::to_matrix(shape.points(Shape::named_poses()[pose].angles)), faces));
  }

  const CP::Target_3& target() const { return m_target; }

  CP::Target_3 mirrored_target() const
  {
    CP::Target_3 result = m_target;
    result.points
      = CP::align_target(result.points, m_surface.points,
                         CP::vertex_area_shares(m_surface.points, m_surface.triangles), true);
    result.summary.reflected = !result.summary.reflected;
    return result;
  }

  CP::Target_3 scaled_surface(const double factor) const
  {
    CP::Target_3 result = m_target;
    result.points = factor * m_surface.points;
    result.is_given = true;
    return result;
  }

  CP::Result registered_pose(const CP::Target_3& target, const CP::Component_options& options) const
  {
    return CP::registered_pose(m_surface, m_coarse, m_fields, target, m_body, options);
  }

private:
  explicit Steps(const CP::Prepared_surface_3& prepared)
    : m_surface(prepared.components.front().surface), m_coarse(CP::coarse_surface(m_surface)),
      m_fields(CP::landmark_fields(m_coarse)),
      m_target(CP::mds_target(m_surface, m_coarse, m_fields)),
      m_body(CP::surface_body(m_surface, m_coarse, m_fields))
  {}

  CP::Surface_component_3 m_surface;
  CP::Coarse_surface_3 m_coarse;
  CP::Landmark_fields_3 m_fields;
  CP::Target_3 m_target;
  CP::Surface_body_3 m_body;
};

template <class Shape>
class Rounds : public testing::Test
{};

using Shapes = testing::Types<Articulated_figure, Articulated_animal>;
TYPED_TEST_SUITE(Rounds, Shapes);

TYPED_TEST(Rounds, choose_the_image)
{
  const auto steps = Steps::of<TypeParam>(1);
  CP::Component_options options;
  const CP::Result expected = steps.registered_pose(steps.target(), options),
                   result = steps.registered_pose(steps.mirrored_target(), options);
  EXPECT_TRUE(expected.summary.target.is_handedness_certain);
  EXPECT_TRUE(result.summary.target.is_handedness_certain);
  EXPECT_EQ(result.summary.target.reflected, expected.summary.target.reflected);
  EXPECT_LT(CP::pose_difference(expected.pose, result.pose), 0.02);
  EXPECT_GT(result.summary.iterations,
            expected.summary.iterations); // includes those of both images

  options.takes_mirror_image = true; // the first target is expected to be the mirror image
  const CP::Result opposite = steps.registered_pose(steps.mirrored_target(), options);
  EXPECT_NE(opposite.summary.target.reflected, expected.summary.target.reflected);
  EXPECT_GT(CP::pose_difference(expected.pose, opposite.pose), 0.1);
}

// Whenever the visitor stops the call, the result is the best pose so far for its target, the last one: its
// energy, in which details count as in the final registration, is never higher than if the call had been
// stopped earlier with the same target. (In a round, the energy with half the detail length decreases,
// which this one does not always follow.) All calls of the visitor are tried, the last ones of rounds as
// well: none follows. Untangling would change the energy.
TYPED_TEST(Rounds, canceled_later_have_no_higher_energy)
{
  const auto steps = Steps::of<TypeParam>(1);
  CP::Component_options options;
  options.number_of_rounds = 2;
  options.registration.injective = false;
  options.visitor = [](const CP::Registration_progress&) { return true; };
  const CP::Result complete = steps.registered_pose(steps.target(), options);
  CP::Point_matrix target(0, 3);
  double previous = 0;
  std::size_t number_of_targets = 0;
  for(int k = 1; k <= complete.summary.iterations; ++k)
  {
    options.visitor = [&](const CP::Registration_progress& progress) {
      EXPECT_LE(progress.iteration, k);
      return progress.iteration < k;
    };
    const CP::Result result = steps.registered_pose(steps.target(), options);
    EXPECT_EQ(result.summary.termination, CP::Registration_summary::CANCELED);
    EXPECT_EQ(result.summary.iterations, k);
    const double energy = result.summary.energy;
    if(target.rows() == result.target->rows() && target == *result.target)
      EXPECT_LE(energy, previous * (1 + 1e-9)) << k;
    else
      ++number_of_targets;
    target = *result.target;
    previous = energy;
  }
  EXPECT_GT(number_of_targets, complete.summary.rounds.size()); // some are scaled
  EXPECT_EQ(target, *complete.target);
  EXPECT_NEAR(previous, complete.summary.energy, 1e-9);
}

// The mirror image of the target of an animal is inside out.
TEST(Collapsed_body, is_registered_with_a_larger_detail_length)
{
  const auto steps = Steps::of<Articulated_animal>(0);
  CP::Target_3 target = steps.mirrored_target();
  target.is_given = true; // there is no choice
  CP::Component_options options;
  options.number_of_rounds = 0;
  const auto is_collapsed = [](const CP::Registration_summary& summary) {
    return std::any_of(summary.warnings.begin(), summary.warnings.end(), [](const std::string& w) {
      return w.find("lost more than half of its volume") != std::string::npos;
    });
  };
  const auto result_for = [&](const double factor) {
    CP::Component_options changed = options;
    changed.registration.detail_length *= factor;
    changed.registration.injective = false;
    changed.registration.energy_tolerance = 1e-3;
    changed.registration.move_tolerance = 5e-3;
    changed.volume_ratio_limit = 1.15;
    return steps.registered_pose(target, changed);
  };
  const CP::Result soft = result_for(0.5), softer = result_for(1.5), stiff = result_for(3);
  EXPECT_LT(soft.summary.volume_ratio, 0.5);
  EXPECT_TRUE(is_collapsed(soft.summary));
  EXPECT_GT(stiff.summary.volume_ratio, 0.5);
  EXPECT_FALSE(is_collapsed(stiff.summary));
  options.number_of_rounds = 1;
  options.volume_ratio_limit = 1.15;
  const CP::Result result = steps.registered_pose(target, options);
  ASSERT_EQ(result.summary.rounds.size(), 1u);
  EXPECT_TRUE(result.summary.rounds[0].energy == stiff.summary.energy
              || result.summary.rounds[0].energy == softer.summary.energy);
  EXPECT_GT(result.summary.iterations,
            2 * soft.summary.iterations + softer.summary.iterations + stiff.summary.iterations);
}

// Hardly anything rotates towards a target that is the surface scaled: with fixed rotations, the energy
// is quadratic, and one iteration from any pose leads to its minimum; prolonged by a quarter, beyond it. All edges have about
// the same strain, which is linear in the points.
TEST(Last_round, has_less_strain_than_with_half_the_detail_length)
{
  const auto steps = Steps::of<Articulated_figure>(0);
  const CP::Target_3 target = steps.scaled_surface(1.1);
  CP::Component_options options;
  options.registration.injective = false;
  options.number_of_rounds = 0;
  const double full = steps.registered_pose(target, options).summary.median_edge_strain;
  CP::Component_options soft_options = options;
  soft_options.registration.detail_length /= 2;
  const double soft = steps.registered_pose(target, soft_options).summary.median_edge_strain;
  EXPECT_GT(soft, 1.2 * full);
  const double tolerance = 0.1 * (soft - full);
  options.number_of_rounds = 1;
  const auto one = steps.registered_pose(target, options).summary.rounds;
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(one[0].median_edge_strain, soft + 1.25 * (full - soft), tolerance);
  options.number_of_rounds = 2;
  const auto two = steps.registered_pose(target, options).summary.rounds;
  ASSERT_GE(two.size(), 1u);
  EXPECT_NEAR(two[0].median_edge_strain, soft, tolerance);
}

} // namespace test_rounds
