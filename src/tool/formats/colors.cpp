// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Canonical_pose_tool {

namespace {

const Color GRAY = {128, 128, 128};

Color viridis(const double fraction)
{
  constexpr std::array<std::array<double, 3>, 9> stops = {{{68, 1, 84},
                                                           {71, 45, 123},
                                                           {59, 82, 139},
                                                           {44, 113, 142},
                                                           {33, 145, 140},
                                                           {39, 173, 129},
                                                           {93, 201, 99},
                                                           {170, 220, 50},
                                                           {253, 231, 37}}};
  const double position = (std::min)((std::max)(fraction, 0.), 1.) * (stops.size() - 1);
  const std::size_t stop = (std::min)(static_cast<std::size_t>(position), stops.size() - 2);
  const double share = position - static_cast<double>(stop);
  Color color;
  for(std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<unsigned char>(
      std::lround((1 - share) * stops[stop][k] + share * stops[stop + 1][k]));
  return color;
}

} // namespace

unsigned char byte_of(const double value, const double largest)
{
  const double share = std::isfinite(value) ? value / largest : 0;
  return static_cast<unsigned char>(std::lround(255 * (std::min)((std::max)(share, 0.), 1.)));
}

// Hues by the golden ratio; brighter and darker by turns.
Color color_of_part(const std::size_t part)
{
  const double hue = std::fmod(static_cast<double>(part) * 0.618033988749895, 1.);
  const double value = part % 2 == 0 ? 230 : 170;
  constexpr double phases[] = {0, 4, 2};
  Color color;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const double distance = std::abs(std::fmod(6 * hue + phases[k], 6.) - 3) - 1;
    const double saturated = (std::min)((std::max)(distance, 0.), 1.);
    color[k] = static_cast<unsigned char>(value * (.25 + .75 * saturated));
  }
  return color;
}

std::vector<Color> colors_of_values(const Eigen::VectorXd& values, const double minimum,
                                    const double maximum)
{
  std::vector<Color> colors;
  for(const double value : values)
    colors.push_back(value < 0           ? GRAY
                     : maximum > minimum ? viridis((value - minimum) / (maximum - minimum))
                                         : viridis(0));
  return colors;
}

} // namespace Canonical_pose_tool
