// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_PROGRESS_LINE_H
#define CGAL_CANONICAL_POSE_3_TOOL_PROGRESS_LINE_H

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

namespace Canonical_pose_tool {

// One line of a terminal: what is being done, and for how long. It appears after two seconds, is rewritten
// five times per second, and is cleared at the end.
class Progress_line
{
public:
  explicit Progress_line(std::ostream& out) : m_out(out), m_thread([this] { run(); }) {}
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  ~Progress_line()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_ends = true;
    }
    m_wake_up.notify_one();
    m_thread.join();
    clear();
  }

  // An empty text clears the line, so that other output can follow.
  void show(const std::string& text)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_text = text;
    if(text.empty())
      clear();
  }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr int WIDTH = 76;

  void run()
  {
    constexpr std::chrono::milliseconds delay(2000), interval(200);
    std::unique_lock<std::mutex> lock(m_mutex);
    while(!m_wake_up.wait_for(lock, interval, [this] { return m_ends; }))
      if(Clock::now() - m_start >= delay && !m_text.empty())
      {
        const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
        char text[WIDTH + 1];
        std::snprintf(text, sizeof(text), "%.0f s: %s", seconds, m_text.c_str());
        write(text);
        m_is_visible = true;
      }
  }

  void clear()
  {
    if(m_is_visible)
      write("");
    m_is_visible = false;
  }

  void write(const char* const text)
  {
    char line[WIDTH + 3];
    std::snprintf(line, sizeof(line), "\r%-*s\r", WIDTH, text);
    m_out << line << std::flush;
  }

  std::ostream& m_out;
  const Clock::time_point m_start = Clock::now();
  std::mutex m_mutex;
  std::condition_variable m_wake_up;
  std::string m_text;
  bool m_ends = false, m_is_visible = false;
  std::thread m_thread; // the last one, since it uses the others
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_PROGRESS_LINE_H
