// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a tool without tinygltf does about glTF.

#include "Mesh_file.h"
#include "Shown_surface.h"
#include "readers.h"

#include <stdexcept>
#include <string>

namespace Canonical_pose_tool {

bool is_gltf_available() { return false; }

void read_gltf(const std::string&, const std::string&, Mesh_file&)
{
  throw std::invalid_argument("this program was built without glTF");
}

std::optional<std::string> self_contained_glb(const std::string&, const std::string&)
{
  return std::nullopt;
}

std::vector<std::string> files_of_gltf(const std::string&) { return {}; }

void load_appearance_of_gltf(Mesh_file&) {}

bool is_rewritable_glb(const Mesh_file&) { return false; }

void rewrite_glb(std::ostream&, const Mesh_file&, const std::vector<std::array<double, 3>>&)
{
  throw std::invalid_argument("this program was built without glTF");
}

std::vector<std::string> attributes_of_gltf(const Mesh_file&) { return {}; }

void write_glb(std::ostream&, const Shown_surface&)
{
  throw std::invalid_argument("this program was built without glTF");
}

} // namespace Canonical_pose_tool
