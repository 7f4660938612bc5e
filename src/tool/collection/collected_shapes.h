// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COLLECTED_SHAPES_H
#define CGAL_CANONICAL_POSE_3_TOOL_COLLECTED_SHAPES_H

#include <string>
#include <vector>

namespace Canonical_pose_tool {

// Whether this is the extension of a file that is read as a surface.
bool is_of_surfaces(const std::string& extension);

// The absolute path, with links as they are.
std::string normal_path(const std::string& path);

// The paths of the surfaces that the inputs name: files, folders and @lists; sorted, without duplicates.
// Throws std::invalid_argument.
std::vector<std::string> shapes_of(const std::vector<std::string>& inputs);

// The number of bytes and their cyclic redundancy check; empty if the file cannot be read.
std::string checksum_of(const std::string& path);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COLLECTED_SHAPES_H
