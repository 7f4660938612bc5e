// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_CHILD_PROCESS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_CHILD_PROCESS_H

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Canonical_pose_benchmark {

/// The limits of a child process; 0: unlimited.
struct Limits
{
  double seconds = 0;
  /// of data, including initial buffers of libraries; if supported by the system (as on Linux)
  std::size_t megabytes = 0;
};

/// A function that runs in a separate process, so that it cannot terminate this one: neither by a
/// crash, nor an endless loop, nor lack of memory. POSIX only.
///
/// The process is a fork of this one. Start it before this process has created threads: they do not
/// exist in the fork, and waiting for them never ends.
class Child_process
{
public:
  enum Ending {
    RETURNED,        ///< `output()` is the result of the function
    REFUSED,         ///< std::invalid_argument; `output()` is its message
    THREW,           ///< another exception; `output()` is its message
    OUT_OF_MEMORY,   ///< std::bad_alloc, or killed by the system
    OUT_OF_TIME,     ///< killed at the time limit
    KILLED_BY_SIGNAL ///< `output()` is the name of the signal
  };

  /// Starts `work`.
  Child_process(const std::function<std::string()>& work, const Limits& limits) : m_limits(limits)
  {
    int ends[2];
    std::fflush(nullptr); // otherwise, the fork would print it, too
    if(pipe(ends) != 0 || (m_id = fork()) < 0)
      throw std::runtime_error("cannot start a process");
    if(m_id == 0)
    {
      close(ends[0]);
      run(work, ends[1]);
    }
    close(ends[1]);
    m_pipe = ends[0];
    fcntl(m_pipe, F_SETFL, O_NONBLOCK);
  }

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  ~Child_process()
  {
    if(m_is_running)
    {
      kill(m_id, SIGKILL);
      waitpid(m_id, nullptr, 0);
    }
    close(m_pipe);
  }

  /// Reads the output of the child, kills it at the time limit, and returns whether it has ended.
  bool has_ended()
  {
    if(!m_is_running)
      return true;
    read();
    const bool is_late = m_limits.seconds > 0 && elapsed() > m_limits.seconds;
    if(is_late)
      kill(m_id, SIGKILL);
    int status = 0;
    rusage usage;
    if(wait4(m_id, &status, is_late ? 0 : WNOHANG, &usage) == 0)
      return false;
    read();
    m_is_running = false;
    m_seconds = elapsed();
    m_peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
    note_ending(status, is_late);
    return true;
  }

  /// Waits until the child has ended.
  void wait()
  {
    while(!has_ended())
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  /// \name After the end
  /// @{
  Ending ending() const { return m_ending; }
  const std::string& output() const { return m_output; }
  /// a description of the failure
  std::string description() const
  {
    return m_ending == OUT_OF_MEMORY ? "out of memory"
           : m_ending == OUT_OF_TIME ? "out of time"
                                     : m_output;
  }
  double seconds() const { return m_seconds; }
  double peak_megabytes() const { return m_peak_megabytes; }
  /// @}

private:
  using Clock = std::chrono::steady_clock;
  static constexpr int first_exit_code = 200; // higher than exit codes of libraries

  [[noreturn]] void run(const std::function<std::string()>& work, const int pipe_end) const
  {
    if(m_limits.megabytes > 0)
    {
      const rlim_t bytes = static_cast<rlim_t>(m_limits.megabytes) << 20;
      const rlimit limit = {bytes, bytes};
      setrlimit(RLIMIT_DATA, &limit);
    }
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    std::string output;
    Ending ending = RETURNED;
    try
    {
      output = work();
    }
    catch(const std::bad_alloc&)
    {
      ending = OUT_OF_MEMORY;
    }
    catch(const std::invalid_argument& e)
    {
      ending = REFUSED;
      output = e.what();
    }
    catch(const std::exception& e)
    {
      ending = THREW;
      output = e.what();
    }
    catch(...)
    {
      ending = THREW;
      output = "an exception of unknown type";
    }
    for(std::size_t done = 0; done < output.size();)
    {
      const ssize_t written = write(pipe_end, output.data() + done, output.size() - done);
      if(written <= 0)
        break;
      done += static_cast<std::size_t>(written);
    }
    std::fflush(nullptr);
    _exit(first_exit_code + ending);
  }

  double elapsed() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  void read()
  {
    char buffer[65536];
    for(ssize_t n; (n = ::read(m_pipe, buffer, sizeof(buffer))) > 0;)
      m_output.append(buffer, static_cast<std::size_t>(n));
  }

  void note_ending(const int status, const bool is_late)
  {
    if(is_late)
      m_ending = OUT_OF_TIME;
    else if(WIFEXITED(status) && WEXITSTATUS(status) >= first_exit_code)
      m_ending = static_cast<Ending>(WEXITSTATUS(status) - first_exit_code);
    else if(WIFEXITED(status))
    {
      m_ending = THREW;
      m_output = "the process was ended from within";
    }
    else if(WTERMSIG(status) == SIGKILL) // not by us
      m_ending = OUT_OF_MEMORY;
    else
    {
      m_ending = KILLED_BY_SIGNAL;
      m_output = "signal " + std::to_string(WTERMSIG(status));
      if(const char* description = strsignal(WTERMSIG(status)))
        m_output += std::string(", ") + description;
    }
  }

  Limits m_limits;
  pid_t m_id = 0;
  int m_pipe = -1;
  bool m_is_running = true;
  Clock::time_point m_start = Clock::now();
  Ending m_ending = RETURNED;
  std::string m_output;
  double m_seconds = 0, m_peak_megabytes = 0;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_CHILD_PROCESS_H
