// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Command_line.h"
#include "command_options.h"
#include "commands/commands.h"

#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// What `command --help` ends with.
std::string examples(const Command& command)
{
  std::string result = command.examples.empty() ? "" : "Examples:";
  for(const char* const example : command.examples)
    result += std::string("\n  canonical-pose ") + example;
  return result;
}

// The first word that is the name of a command; null if there is none.
const Command* first_command(char** const begin, char** const end)
{
  for(char** word = begin; word != end; ++word)
    for(const Command* const command : COMMANDS)
      if(*word == std::string(command->name))
        return command;
  return nullptr;
}

// CLI11 takes the next word as the value of "--option=".
void check_values(char** const begin, char** const end)
{
  for(char** word = begin; word != end; ++word)
    if(const std::string text = *word;
       text.compare(0, 2, "--") == 0 && text.size() > 3 && text.find('=') == text.size() - 1)
      throw CLI::ValidationError(text.substr(0, text.size() - 1), "the value is empty");
}

// What is wrong. CLI11 names words that it does not expect in reverse order.
std::string message_of(const CLI::App& app, const CLI::Error& error)
{
  const std::vector<std::string> words = app.remaining(true);
  if(error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError) || words.empty())
    return error.what();
  return std::string("The following argument") + (words.size() == 1 ? " was" : "s were")
         + " not expected: " + CLI::detail::join(words, " ");
}

} // namespace

std::optional<int> parse_command_line(const int argc, char* argv[], Arguments& arguments)
{
  Raw_arguments raw;
  CLI::App app("Brings 3D shapes into their detail-preserving canonical pose.", "canonical-pose");
  app.set_version_flag("--version", CGAL_CANONICAL_POSE_3_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* app, const CLI::Error& error) { // one line for bad values
    return "canonical-pose: " + message_of(*app, error)
           + (error.get_name() == "ValidationError" ? "\n" : "; see --help\n");
  });
  const Command* const chosen = first_command(argv + 1, argv + argc);
  for(const Command* const command : COMMANDS)
  {
    CLI::App& subcommand = *app.add_subcommand(command->name, command->summary);
    subcommand.footer(examples(*command));
    if(*command->summary == '\0')
      subcommand.group(""); // for `collection`, not for people
    // Only the options of the command that is run: their defaults are in `arguments`.
    if(command == chosen)
    {
      Command_options options = {subcommand, arguments, raw};
      command->add_options(options);
      // Flags have no value: for collections, --injective=false would be --injective.
      for(CLI::Option* const option : subcommand.get_options())
        if(option->get_expected_max() == 0)
          option->disable_flag_override();
    }
  }
  try
  {
    if(chosen == nullptr && argc > 1 && argv[1][0] != '-')
      throw CLI::ExtrasError("'" + std::string(argv[1]) + "' is not a command",
                             CLI::ExitCodes::ExtrasError);
    check_values(argv + 1, argv + argc);
    app.parse(argc, argv);
    take(raw, arguments);
  }
  catch(const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : WRONG_USAGE;
  }
  arguments.command = chosen;
  return std::nullopt;
}

} // namespace Canonical_pose_tool
