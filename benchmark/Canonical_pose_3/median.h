// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_MEDIAN_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_MEDIAN_H

#include <algorithm>
#include <vector>

namespace Canonical_pose_benchmark {

/// The upper one if their number is even.
inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_MEDIAN_H
