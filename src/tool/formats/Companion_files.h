// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMPANION_FILES_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMPANION_FILES_H

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// The files that one that is written has beside it, for instance materials. They are written after it.
struct Companion_files
{
  std::filesystem::path path;                       // where that file will be
  std::vector<std::string> kept = {};               // files that are not replaced
  std::map<std::string, std::string> contents = {}; // by names
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMPANION_FILES_H
