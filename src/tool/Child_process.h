// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_CHILD_PROCESS_H
#define CGAL_CANONICAL_POSE_3_TOOL_CHILD_PROCESS_H

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace Canonical_pose_tool {

// This program, run again by a process of its own, which ends at the latest with its parent.
class Child_process
{
public:
  // 0: no limit.
  struct Limits
  {
    double seconds = 0;
    double megabytes = 0; // of resident memory
  };

  struct Ending
  {
    int exit_code = 0; // if there is no signal
    int signal = 0;
    bool timed_out = false, out_of_memory = false; // ended for that
    std::string output, errors;
    double seconds = 0;
  };

  // Throws std::runtime_error if there can be no further process.
  Child_process(const std::vector<std::string>& arguments, const Limits& limits);
  ~Child_process();
  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  // Returns how it ended, if it did; ends it at its limits. Does not wait.
  std::optional<Ending> ending();

private:
  using Clock = std::chrono::steady_clock;

  void end_at_limits(double seconds);

  pid_t m_process = -1;
  int m_output = -1, m_errors = -1;
  Limits m_limits;
  Clock::time_point m_start = Clock::now();
  bool m_timed_out = false, m_out_of_memory = false;
  double m_end_of_grace = 0, m_next_look_at_memory = 0; // seconds since the start
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_CHILD_PROCESS_H
