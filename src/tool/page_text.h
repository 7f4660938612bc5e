// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_PAGE_TEXT_H
#define CGAL_CANONICAL_POSE_3_TOOL_PAGE_TEXT_H

namespace Canonical_pose_tool {

// The text of a page before and after its scenes; see src/page.
extern const char* const PAGE_HEAD;
extern const char* const PAGE_TAIL;

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_PAGE_TEXT_H
