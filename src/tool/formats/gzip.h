// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_GZIP_H
#define CGAL_CANONICAL_POSE_3_TOOL_GZIP_H

#include <string>
#include <string_view>

// Compressed files, by zlib.

namespace Canonical_pose_tool {

// Whether the tool was built with zlib.
bool is_gzip_available();

// Whether a file that begins like this is compressed.
bool is_gzip(std::string_view bytes);

// Returns what a compressed file contains. Throws std::invalid_argument if it is damaged or truncated, or
// there is no zlib.
std::string decompressed(const std::string& bytes);

// Returns a compressed file, which depends on nothing but its content. Throws std::runtime_error if zlib fails.
std::string compressed(const std::string& bytes);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_GZIP_H
