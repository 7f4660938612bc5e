// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace Canonical_pose_tool {

namespace {

[[noreturn]] void fail(const std::string& what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

// A file in memory, which nobody has to remove.
int open_memory_file()
{
  const int file = memfd_create("canonical-pose", MFD_CLOEXEC);
  if(file < 0)
    fail("a temporary file cannot be created");
  return file;
}

std::string content_of(const int file)
{
  std::string result;
  std::array<char, 1 << 16> part;
  lseek(file, 0, SEEK_SET);
  for(ssize_t n; (n = read(file, part.data(), part.size())) > 0;)
    result.append(part.data(), static_cast<std::size_t>(n));
  return result;
}

// A limit of the address space would include what is only reserved, and libraries wait for it without end.
double resident_megabytes(const pid_t process)
{
  std::ifstream in("/proc/" + std::to_string(process) + "/statm");
  double all = 0, resident = 0; // pages
  in >> all >> resident;
  return in ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576 : 0;
}

// One thread: libraries that start threads of their own are told so, too.
std::vector<std::string> environment_of_child()
{
  std::vector<std::string> result = {"OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"};
  for(char** entry = environ; *entry; ++entry)
  {
    const std::string text = *entry;
    const bool is_replaced
      = text.rfind("OMP_NUM_THREADS=", 0) == 0 || text.rfind("OPENBLAS_NUM_THREADS=", 0) == 0;
    if(!is_replaced)
      result.push_back(text);
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts)
{
  std::vector<char*> result;
  for(std::string& text : texts)
    result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

} // namespace

Child_process::Child_process(const std::vector<std::string>& arguments, const Limits& limits)
  : m_limits(limits)
{
  m_output = open_memory_file();
  m_errors = open_memory_file();
  std::vector<std::string> words = {"canonical-pose"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_of_child();
  const std::vector<char*> argv = pointers(words), envp = pointers(environment);
  const pid_t parent = getpid();
  m_process = fork();
  if(m_process < 0)
    fail("no further process can be started");
  if(m_process > 0)
    return;

  // Between fork() and exec(), only calls that are safe in a signal handler.
  prctl(PR_SET_PDEATHSIG, SIGTERM); // on which it removes its files
  if(getppid() != parent)
    _exit(EXIT_FAILURE);
  rlimit no_core_file = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core_file);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(m_output, STDOUT_FILENO);
  dup2(m_errors, STDERR_FILENO);
  execve("/proc/self/exe", argv.data(), envp.data());
  _exit(EXIT_FAILURE);
}

Child_process::~Child_process()
{
  if(m_process > 0)
  {
    kill(m_process, SIGKILL);
    waitpid(m_process, nullptr, 0);
  }
  close(m_output);
  close(m_errors);
}

// First by a signal on which it removes its files, then by one that cannot be ignored.
void Child_process::end_at_limits(const double seconds)
{
  constexpr double grace = 2, time_between_looks = .01;
  if(m_timed_out || m_out_of_memory)
  {
    if(seconds > m_end_of_grace)
      kill(m_process, SIGKILL);
    return;
  }
  m_timed_out = m_limits.seconds > 0 && seconds > m_limits.seconds;
  if(m_limits.megabytes > 0 && seconds >= m_next_look_at_memory)
  {
    m_out_of_memory = resident_megabytes(m_process) > m_limits.megabytes;
    m_next_look_at_memory = seconds + time_between_looks;
  }
  if(!m_timed_out && !m_out_of_memory)
    return;
  m_end_of_grace = seconds + grace;
  kill(m_process, SIGTERM);
}

std::optional<Child_process::Ending> Child_process::ending()
{
  const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
  int status = 0;
  const pid_t ended = waitpid(m_process, &status, WNOHANG);
  if(ended == 0)
  {
    end_at_limits(seconds);
    return std::nullopt;
  }
  if(ended < 0)
    fail("a process cannot be awaited");
  m_process = -1;
  Ending result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.timed_out = m_timed_out;
  result.out_of_memory = m_out_of_memory;
  result.output = content_of(m_output);
  result.errors = content_of(m_errors);
  result.seconds = seconds;
  return result;
}

} // namespace Canonical_pose_tool
