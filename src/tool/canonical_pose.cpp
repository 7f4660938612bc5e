// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool, see canonical_pose.md: parse, call, write.

#include "Command_line.h"
#include "Output_files.h"
#include "Progress_line.h"
#include "commands/commands.h"
#include "formats/Mesh_file.h"

#include <CGAL/assertions_behaviour.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace {

using namespace Canonical_pose_tool;

// The line that states the reason for a failure. Reasons that begin with the name of another file need no subject.
void complain(const std::string& subject, const std::exception& error)
{
  const bool is_out_of_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  const std::string reason = is_out_of_memory ? "out of memory" : error.what();
  std::string message = reason.rfind('\'', 0) == 0 ? reason : subject + reason;
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "canonical-pose: " << message << '\n';
}

// CGAL prints its errors; the tool reports them in one line of its own.
void do_not_print(const char*, const char*, const char*, int, const char*) {}

} // namespace

int main(int argc, char* argv[])
{
  remove_files_on_signals();
#ifdef __GLIBC__
  // Otherwise large arrays come from the system, which clears them each time: a sixth of the time of large meshes.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
  CGAL::set_error_handler(do_not_print);
  CGAL::set_warning_handler(do_not_print);
  std::string subject;
  try
  {
    Arguments arguments;
    if(const std::optional<int> exit_code = parse_command_line(argc, argv, arguments))
      return *exit_code;
    if(!arguments.input.empty())
      subject = name_of_input(arguments.input) + ": ";
    std::optional<Progress_line> line;
    if(!arguments.quiet && isatty(STDERR_FILENO))
    {
      line.emplace(std::cerr);
      arguments.is_watched = true;
      arguments.say = [&line](const std::string& text) { line->show(text); };
    }
    if(!arguments.input.empty())
      arguments.say("reading " + name_of_input(arguments.input));
    const int exit_code = arguments.command->run(arguments);
    line.reset();
    if(!std::cout.flush())
      throw std::runtime_error("the standard output cannot be written");
    return exit_code;
  }
  catch(const Usage_error& error)
  {
    complain("", error);
    return WRONG_USAGE;
  }
  catch(const std::exception& error)
  {
    complain(subject, error);
  }
  catch(...)
  {
    complain(subject, std::runtime_error("unknown error"));
  }
  return EXIT_FAILURE;
}
