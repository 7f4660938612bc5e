// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Which image of the target is chosen after the rounds does not depend on the one they start from; a body that
// collapses to a target that is inside out is registered once more, exactly as with a larger detail length.
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

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_examples::Articulated_figure;

namespace {

template <class Shape>
CP::Prepared_surface_3 prepared_shape(const std::size_t pose)
{
  static const Shape shape(2000);
  std::vector<std::vector<std::size_t>> faces;
  for(const auto& t : shape.triangles())
    faces.emplace_back(t.begin(), t.end());
  return CP::prepare_surface(
    Canonical_pose_test::to_matrix(shape.points(Shape::named_poses()[pose].angles)), faces);
}

CP::Target_3 mirror_image(CP::Target_3 target, const CP::Surface_component_3& surface)
{
  target.points = CP::align_target(target.points, surface.points,
                                   CP::vertex_area_shares(surface.points, surface.triangles), true);
  target.summary.reflected = !target.summary.reflected;
  return target;
}

template <class Shape>
class Rounds : public testing::Test
{};

using Shapes = testing::Types<Articulated_figure, Articulated_animal>;
TYPED_TEST_SUITE(Rounds, Shapes);

TYPED_TEST(Rounds, choose_the_image)
{
  const auto prepared = prepared_shape<TypeParam>(1);
  const auto& surface = prepared.components.front().surface;
  CP::Options options = prepared.components.front().options;
  const auto coarse = CP::coarse_surface(surface, options);
  const auto fields = CP::landmark_fields(coarse, options);
  const auto target = CP::mds_target(surface, coarse, fields, options);
  const auto body = CP::surface_body(surface, coarse, fields, options);
  const auto pose_of = [&](const CP::Target_3& first) {
    return CP::registered_pose(surface, coarse, first, body, options);
  };
  const CP::Result expected = pose_of(target), result = pose_of(mirror_image(target, surface));
  EXPECT_TRUE(expected.summary.target.is_handedness_certain);
  EXPECT_TRUE(result.summary.target.is_handedness_certain);
  EXPECT_EQ(result.summary.target.reflected, expected.summary.target.reflected);
  EXPECT_LT(CP::pose_difference(expected.pose, result.pose), 0.02);
  EXPECT_GT(result.summary.iterations,
            expected.summary.iterations); // includes those of both images

  options.takes_mirror_image = true; // the first target is expected to be the mirror image
  const CP::Result opposite = pose_of(mirror_image(target, surface));
  EXPECT_NE(opposite.summary.target.reflected, expected.summary.target.reflected);
  EXPECT_GT(CP::pose_difference(expected.pose, opposite.pose), 0.1);
}

} // namespace

// The mirror image of the target of an animal is inside out.
TEST(Collapsed_body, is_registered_with_a_larger_detail_length)
{
  const auto prepared = prepared_shape<Articulated_animal>(0);
  const auto& surface = prepared.components.front().surface;
  CP::Options options = prepared.components.front().options;
  const auto coarse = CP::coarse_surface(surface, options);
  const auto fields = CP::landmark_fields(coarse, options);
  CP::Target_3 target = mirror_image(CP::mds_target(surface, coarse, fields, options), surface);
  target.is_given = true; // there is no choice
  const auto body = CP::surface_body(surface, coarse, fields, options);
  options.number_of_rounds = 0;
  const auto is_collapsed = [](const CP::Registration_summary& summary) {
    return std::any_of(summary.warnings.begin(), summary.warnings.end(), [](const std::string& w) {
      return w.find("lost more than half of its volume") != std::string::npos;
    });
  };
  const auto result_for = [&](const double factor) {
    CP::Options changed = options;
    changed.registration.detail_length *= factor;
    changed.registration.injective = false;
    changed.registration.energy_tolerance = 1e-3;
    changed.registration.move_tolerance = 5e-3;
    changed.volume_ratio_limit = 1.15;
    return CP::registered_pose(surface, coarse, target, body, changed);
  };
  const CP::Result soft = result_for(0.5), stiff = result_for(3);
  EXPECT_LT(soft.summary.volume_ratio, 0.5);
  EXPECT_TRUE(is_collapsed(soft.summary));
  EXPECT_GT(stiff.summary.volume_ratio, 0.5);
  EXPECT_FALSE(is_collapsed(stiff.summary));
  options.number_of_rounds = 1;
  options.volume_ratio_limit = 1.15;
  const CP::Result result = CP::registered_pose(surface, coarse, target, body, options);
  ASSERT_EQ(result.summary.rounds.size(), 1u);
  EXPECT_EQ(result.summary.rounds[0].energy, stiff.summary.energy);
  EXPECT_GT(result.summary.iterations, soft.summary.iterations + stiff.summary.iterations);
}
