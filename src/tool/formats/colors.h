// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COLORS_H
#define CGAL_CANONICAL_POSE_3_TOOL_COLORS_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Canonical_pose_tool {

// Red, green and blue from 0 to 255, sRGB.
using Color = std::array<unsigned char, 3>;

// A share of the largest value, from 0 to 255; 0 if it is not finite.
unsigned char byte_of(double value, double largest);

// Colors of successive parts differ clearly.
Color color_of_part(std::size_t part);

// The color map viridis, from dark blue at `minimum` to yellow at `maximum`; gray for negative
// values, which stand for no value.
std::vector<Color> colors_of_values(const Eigen::VectorXd& values, double minimum, double maximum);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COLORS_H
