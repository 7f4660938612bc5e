// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_PROGRESS_LINE_H
#define CGAL_CANONICAL_POSE_3_TOOL_PROGRESS_LINE_H

#include <CGAL/Canonical_pose_3/Registration_progress.h>

#include <cstdio>
#include <ostream>

namespace Canonical_pose_tool {

// One line of a terminal, rewritten for each iteration and cleared at the end.
class Progress_line
{
public:
  explicit Progress_line(std::ostream& out) : m_out(out) {}
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  ~Progress_line() { write(""); }

  void show(const CGAL::Canonical_pose_3::Registration_progress& progress)
  {
    char text[WIDTH + 1];
    std::snprintf(text, sizeof(text), "iteration %d, energy %.6g, largest move %.2g of L",
                  progress.iteration, progress.energy, progress.largest_move);
    write(text);
  }

private:
  static constexpr int WIDTH = 76;

  void write(const char* text)
  {
    char line[WIDTH + 3];
    std::snprintf(line, sizeof(line), "\r%-*s\r", WIDTH, text);
    m_out << line << std::flush;
  }

  std::ostream& m_out;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_PROGRESS_LINE_H
