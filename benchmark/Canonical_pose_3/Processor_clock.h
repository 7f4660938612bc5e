// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_PROCESSOR_CLOCK_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_PROCESSOR_CLOCK_H

#include <ctime>

namespace Canonical_pose_benchmark {

/// Measures the processor time of this process, all threads together, from its construction: unlike
/// the time that passes, it hardly depends on what else the machine does.
class Processor_clock
{
public:
  double seconds() const { return static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC; }

private:
  std::clock_t m_start = std::clock();
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_PROCESSOR_CLOCK_H
