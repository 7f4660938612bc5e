// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_MATERIAL_OF_GLTF_H
#define CGAL_CANONICAL_POSE_3_TOOL_MATERIAL_OF_GLTF_H

#include "Appearance.h"

#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace Canonical_pose_tool {

// How texture coordinates of a primitive become those of the images of its material.
struct Texture_transform
{
  int set = 0; // the number of the attribute TEXCOORD
  std::array<double, 2> offset = {0, 0}, scale = {1, 1};
  double rotation = 0;

  std::array<float, 2> operator()(const double u, const double v) const
  {
    const double x = scale[0] * u, y = scale[1] * v;
    return {static_cast<float>(offset[0] + std::cos(rotation) * x + std::sin(rotation) * y),
            static_cast<float>(offset[1] - std::sin(rotation) * x + std::cos(rotation) * y)};
  }

  auto values() const { return std::tie(set, offset, scale, rotation); }
  bool operator==(const Texture_transform& other) const { return values() == other.values(); }
};

// That of the color or, if this has no image, of the first other image.
Texture_transform transform_of(const tinygltf::Material& material);

// Reads a material. What it has that a Material has not is added to `missing`.
Material material_of(const tinygltf::Model& model, const tinygltf::Material& material,
                     std::set<std::string>& missing);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_MATERIAL_OF_GLTF_H
