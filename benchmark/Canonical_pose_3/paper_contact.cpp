// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include "paper_tables.h"

namespace Canonical_pose_benchmark {

void print_contact_table(Argument_list&) {}

} // namespace Canonical_pose_benchmark
