// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_LOAD_GLTF_H
#define CGAL_CANONICAL_POSE_3_TOOL_LOAD_GLTF_H

#include <tiny_gltf.h>

#include <string>

namespace Canonical_pose_tool {

// Parses a glTF file, binary or text, with its buffers; `path` is that of the file, beside which
// external buffers are. Images are not read. Nothing is checked that the JSON states about arrays.
// Throws std::invalid_argument.
tinygltf::Model load_gltf(const std::string& bytes, const std::string& path);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_LOAD_GLTF_H
