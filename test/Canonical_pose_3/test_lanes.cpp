// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/heat/Gradient_field.h"

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>

namespace test_lanes {

using namespace CGAL::Canonical_pose_3::internal;

// Calls f(run) with each version of the routine that this processor supports.
template <class Routine, class Function>
void for_each_version(const Function& f)
{
  f([](auto... arguments) { Routine::template run<Vector_of_1>(arguments...); });
  f([](auto... arguments) { Routine::template run<Portable_vector>(arguments...); });
#ifdef CGAL_CANONICAL_POSE_3_HAS_X86_ROUTINES
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    f([](auto... arguments) { run_with_avx2<Routine>(arguments...); });
  if(__builtin_cpu_supports("avx512f"))
    f([](auto... arguments) { run_with_avx512<Routine>(arguments...); });
#endif
}

// One face, u linear on it: the field is minus the unit gradient, and its integral against the
// gradients of the hat functions is known from the corners. NaN functions remain NaN; constants
// yield 0.
TEST(Lanes, every_version_normalizes_gradients)
{
  const Face_in_plane face = {{{2, 0, 1}}, 3., 1., 2.};
  const Eigen::Vector2d slope(0.6, -0.8);
  const double area = 3.;
  // gradients of the hats of the three corners (0,0), (3,0), (1,2)
  const std::array<Eigen::Vector2d, 3> hats = {
    Eigen::Vector2d(-1 / 3., -1 / 3.), Eigen::Vector2d(1 / 3., -1 / 6.), Eigen::Vector2d(0, 0.5)};
  const std::array<double, NUMBER_OF_LANES> scales
    = {1., 1e-290, 1e290, 3e-308, 0., std::numeric_limits<double>::quiet_NaN(), -5., 1e-160};
  Lane_rows u(3 * NUMBER_OF_LANES, 0.);
  for(std::size_t k = 0; k < NUMBER_OF_LANES; ++k)
  {
    u[NUMBER_OF_LANES * 0 + k] = scales[k] * 3 * slope[0];
    u[NUMBER_OF_LANES * 1 + k] = scales[k] * (slope[0] + 2 * slope[1]);
  }
  for_each_version<Unit_descent>([&](const auto& run) {
    Lane_rows result(3 * NUMBER_OF_LANES, 0.);
    run(&face, std::size_t(1), u.data(), result.data());
    for(std::size_t k = 0; k < NUMBER_OF_LANES; ++k)
      for(std::size_t corner = 0; corner < 3; ++corner)
      {
        const double value = result[NUMBER_OF_LANES * std::size_t(face.corners[corner]) + k];
        const double sign = scales[k] > 0 ? 1. : scales[k] < 0 ? -1. : 0.;
        if(scales[k] == scales[k])
          EXPECT_NEAR(value, -sign * area * hats[corner].dot(slope), 1e-14) << k;
        else
          EXPECT_NE(value, value);
      }
  });
}

} // namespace test_lanes
