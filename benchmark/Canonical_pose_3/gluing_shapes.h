// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_GLUING_SHAPES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_GLUING_SHAPES_H

#include "../../test/Canonical_pose_3/shapes.h"

#include <array>
#include <cmath>
#include <cstddef>

// Procedural shapes in which a body may glue separate parts together.

namespace Canonical_pose_benchmark {

using Canonical_pose_test::pi;
using Canonical_pose_test::Points;
using Canonical_pose_test::Triangle_soup;

/// Two fingers: a rod along x that is bent by an angle in the middle, so that its ends are side by
/// side; beyond 180 degrees, they approach, touch and intersect.
class Two_fingers
{
public:
  static constexpr double length = 10, radius = 0.4, begin = 4, end = 6; // range of the bend

  Two_fingers() : m_straight(Canonical_pose_test::tube_soup(161, 40, length, radius)) {}

  /// The rod bent by `angle`.
  Triangle_soup bent(const double angle) const
  {
    Triangle_soup result = m_straight;
    for(auto& p : result.points)
      p = place(p, angle);
    return result;
  }

  /// The angle at which the center of the tip of one finger is at `height` above the center line of
  /// the other; twice the radius: they touch; negative: they intersect. At most the height at 180
  /// degrees.
  double angle_of(const double height) const
  {
    double low = pi, high = 1.5 * pi;
    for(int i = 0; i < 60; ++i)
    {
      const double middle = (low + high) / 2;
      (place({{length, 0, 0}}, middle)[2] > height ? low : high) = middle;
    }
    return low;
  }

  /// The vertices at the tips.
  std::array<Eigen::Index, 2> tips() const
  {
    const auto n = static_cast<Eigen::Index>(m_straight.points.size());
    return {n - 2, n - 1};
  }

private:
  static std::array<double, 3> place(const std::array<double, 3>& p, const double angle)
  {
    if(p[0] <= begin)
      return p;
    const double bend = (std::min)(p[0], end) - begin, straight = p[0] - begin - bend;
    const std::array<double, 3> on_arc
      = Canonical_pose_test::bend({{bend, p[1], p[2]}}, end - begin, angle);
    const double heading = angle * bend / (end - begin);
    return {{begin + on_arc[0] + straight * std::cos(heading), p[1],
             on_arc[2] + straight * std::sin(heading)}};
  }

  Triangle_soup m_straight;
};

/// A plate of width 1 and thickness 1/200; vertex i is below vertex i + n/2.
inline Triangle_soup thin_plate()
{
  return Canonical_pose_test::boundary(
    Canonical_pose_test::tetrahedral_box(100, 100, 1, {{1, 1, 1. / 200}}));
}

/// A torus with a narrow hole, of radius 0.2.
struct Narrow_torus
{
  static constexpr double large = 1, small = 0.8;

  static Triangle_soup surface() { return Canonical_pose_test::torus_soup(120, 96, large, small); }

  static double distance_outside(const Eigen::Vector3d& p)
  {
    return (std::max)(0., std::hypot(std::hypot(p[0], p[1]) - large, p[2]) - small);
  }
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_GLUING_SHAPES_H
