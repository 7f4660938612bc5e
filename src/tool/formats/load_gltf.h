// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_LOAD_GLTF_H
#define CGAL_CANONICAL_POSE_3_TOOL_LOAD_GLTF_H

#include <tiny_gltf.h>

#include <optional>
#include <string>
#include <string_view>

namespace Canonical_pose_tool {

// Parses a glTF file, binary or text, with its buffers; `path` is that of the file, beside which
// external buffers are. Images are not read. Nothing is checked that the JSON states about arrays.
// Throws std::invalid_argument.
tinygltf::Model load_gltf(const std::string& bytes, const std::string& path);

// Throws std::invalid_argument if tinygltf made something else of a file that was loaded: a position or length that is
// negative is 0 then, and primitives that are not valid are left out.
void check_model(const std::string& bytes, const tinygltf::Model& model);

// A binary file with this JSON, this buffer, and chunks after it.
std::string glb_of(const std::string& json, std::string_view buffer, std::string_view rest = {});

// The parts of a binary file that was read.
struct Glb_chunks
{
  std::string_view json, buffer, rest;
};
Glb_chunks chunks_of_glb(const std::string& bytes);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_LOAD_GLTF_H
