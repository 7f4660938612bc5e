// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The targets that the rounds reach are prescribed: an ellipsoid (x, y, z) bent to (x, y, e z + k x y) has the volume
// ratio e, exactly, and a chirality with the sign of k, about .77 for large k (moments of a ball).
#include "engine/pipeline/Handed_rounds.h"

#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_handed_rounds {

namespace CP = CGAL::Canonical_pose_3;

CP::Prepared_surface_3 ellipsoid()
{
  constexpr std::size_t meridians = 20, parallels = 11;
  const double pi = std::acos(-1.);
  CP::Point_matrix points(meridians * parallels + 2, 3);
  std::vector<std::vector<std::size_t>> faces;
  const std::size_t north = meridians * parallels, south = north + 1;
  points.row(north) << 0, 0, 1;
  points.row(south) << 0, 0, -1;
  for(std::size_t j = 0; j < parallels; ++j)
    for(std::size_t i = 0; i < meridians; ++i)
    {
      const double a = 2 * pi * double(i) / meridians, b = pi * double(j + 1) / (parallels + 1);
      const std::size_t next = (i + 1) % meridians, v = j * meridians + i, w = j * meridians + next;
      points.row(v) << 3 * std::cos(a) * std::sin(b), 2 * std::sin(a) * std::sin(b), std::cos(b);
      if(j == 0)
        faces.push_back({north, v, w});
      if(j + 1 == parallels)
        faces.push_back({south, w, v});
      else
      {
        faces.push_back({v, v + meridians, w});
        faces.push_back({w, v + meridians, w + meridians});
      }
    }
  return CP::prepare_surface(points, faces);
}

class Handed_rounds : public testing::Test
{
protected:
  CP::Point_matrix bent(const double e, const double k) const
  {
    CP::Point_matrix result = surface.points;
    result.col(2)
      = e * surface.points.col(2) + k * surface.points.col(0).cwiseProduct(surface.points.col(1));
    return result;
  }

  // From the input, the rounds reach `from_input`, and the next time `again`; from its mirror image,
  // they reach `from_image`.
  CP::internal::Registered_body chosen(const CP::Point_matrix& from_input,
                                       const CP::Point_matrix& from_image,
                                       const CP::Point_matrix& again) const
  {
    const CP::Component_options options;
    const CP::internal::Surface_registration registration(surface, body, options);
    int calls = 0; // that started from the input
    const CP::internal::Rounds rounds(
      registration,
      [&](const CP::Point_matrix& pose, CP::Registration_summary&) {
        CP::internal::Rounds::Refined_target result;
        result.target.points = CP::pose_difference(pose, surface.points) > 1e-3 ? from_image
                               : ++calls == 1                                   ? from_input
                                                                                : again;
        result.target.summary.stress = 0.05;
        return result;
      },
      1);
    CP::Target_3 first;
    first.points = surface.points;
    return CP::internal::Handed_rounds(registration, rounds)(CP::Registration_summary(), first);
  }

  const CP::Prepared_surface_3 prepared = ellipsoid();
  const CP::Surface_component_3& surface = prepared.components.front().surface;
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface);
  const CP::Surface_body_3 body = CP::surface_body(surface, coarse, CP::landmark_fields(coarse));
};

// The image with the positive chirality is inside out at first.
TEST_F(Handed_rounds, turn_the_image_of_the_right_chirality_right_side_out)
{
  const CP::internal::Registered_body result
    = chosen(bent(-0.5, 0.5), bent(0.5, -0.5), bent(0.5, 0.5));
  EXPECT_EQ(result.target.points, bent(0.5, 0.5));
  EXPECT_TRUE(result.target.summary.is_handedness_certain);
}

TEST_F(Handed_rounds, are_uncertain_if_volume_and_chirality_contradict)
{
  const CP::internal::Registered_body result
    = chosen(bent(-0.5, 0.5), bent(0.5, -0.5), bent(-0.5, 0.5));
  EXPECT_EQ(result.target.points, bent(0.5, -0.5));
  EXPECT_FALSE(result.target.summary.is_handedness_certain);
}

// The volume decides if the chirality is small.
TEST_F(Handed_rounds, prefer_the_image_that_is_right_side_out)
{
  const CP::internal::Registered_body result
    = chosen(bent(-1, 0.05), bent(1, -0.05), bent(0.5, 0.5));
  EXPECT_EQ(result.target.points, bent(1, -0.05));
  EXPECT_TRUE(result.target.summary.is_handedness_certain);
}

// So does it just below the limit; but a choice that is not certain is not called certain, and the
// image with the positive chirality gets its second start.
TEST_F(Handed_rounds, do_not_rely_on_a_volume_that_barely_decides)
{
  const CP::Point_matrix barely = bent(1, -0.28);
  const CP::Target_handedness_3 handedness
    = CP::target_handedness(barely, surface.points, surface.triangles,
                            CP::vertex_area_shares(surface.points, surface.triangles));
  ASSERT_FALSE(handedness.is_decided_by_chirality()) << handedness.chirality;
  ASSERT_FALSE(handedness.is_certain()) << handedness.chirality;
  const CP::internal::Registered_body turned = chosen(bent(-1, 0.28), barely, bent(0.5, 0.5));
  EXPECT_EQ(turned.target.points, bent(0.5, 0.5));
  EXPECT_TRUE(turned.target.summary.is_handedness_certain);
  const CP::internal::Registered_body kept = chosen(bent(-1, 0.28), barely, bent(-1, 0.28));
  EXPECT_EQ(kept.target.points, barely);
  EXPECT_FALSE(kept.target.summary.is_handedness_certain);
}

} // namespace test_handed_rounds
