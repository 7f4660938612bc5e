// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_PAPER_TABLES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_PAPER_TABLES_H

#include "Argument_list.h"

namespace Canonical_pose_benchmark {

// The tables of the paper; each takes its options from the list and prints itself in Markdown.

/// Table 1: how much poses change if their targets are computed from noisy surfaces.
void print_noise_table(Argument_list& arguments);

/// Figure 10: how much the pose changes if a hand touches the knee.
void print_contact_table(Argument_list& arguments);

/// Section 8: seconds.
void print_times_table(Argument_list& arguments);

/// Figure 1: classical, least squares and landmark scaling.
void print_scalings_table(Argument_list& arguments);

/// Figure 3: the weights.
void print_weights_table(Argument_list& arguments);

/// The detail length against invariance and strain.
void print_detail_table(Argument_list& arguments);

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_PAPER_TABLES_H
