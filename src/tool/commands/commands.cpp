// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "command_options.h"

#include <stdexcept>
#include <vector>

namespace Canonical_pose_tool {

#if !defined(CANONICAL_POSE_WITH_COLLECTIONS) || !defined(CANONICAL_POSE_WITH_PAGE)

namespace {

void accept_anything(Command_options& o) { o.app.allow_extras(); }

} // namespace

#endif

#ifndef CANONICAL_POSE_WITH_COLLECTIONS

namespace {

int run_without_collections(Arguments&)
{
  throw std::runtime_error("collections are not available in this build, without SQLite");
}

} // namespace

const Command COLLECTION_COMMAND
  = {"collection", "not in this build", {}, accept_anything, run_without_collections},
  SEARCH_COMMAND = {"search", "not in this build", {}, accept_anything, run_without_collections},
  EVALUATE_COMMAND
  = {"evaluate", "not in this build", {}, accept_anything, run_without_collections},
  SHAPE_COMMAND = {"shape", "", {}, accept_anything, run_without_collections};

#endif

#ifndef CANONICAL_POSE_WITH_PAGE

namespace {

int run_without_page(Arguments&)
{
  throw std::runtime_error("pages are not available in this build, without npm");
}

} // namespace

const Command PAGE_COMMAND = {"page", "not in this build", {}, accept_anything, run_without_page};

#endif

const std::vector<const Command*> COMMANDS
  = {&POSE_COMMAND,      &SEGMENT_COMMAND,  &DESCRIBE_COMMAND, &COLLECTION_COMMAND,
     &SEARCH_COMMAND,    &EVALUATE_COMMAND, &CHECK_COMMAND,    &COMPARE_COMMAND,
     &GEODESICS_COMMAND, &MATCH_COMMAND,    &PAGE_COMMAND,     &SHAPE_COMMAND};

} // namespace Canonical_pose_tool
