// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMMAND_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMMAND_OPTIONS_H

#include "Command_line.h"
#include "option_values.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

// What the options of several commands have in common.

namespace Canonical_pose_tool {

using CGAL::Canonical_pose_3::Registration_options;

// Arguments that are converted to options of the library.
struct Raw_arguments
{
  std::string paper_weights, parts = "auto";
  std::vector<std::string> springs, directions, handles, symmetric_pairs, landmarks;
  std::string format; // of the standard output
};

// What a command adds its options to. The defaults are what `arguments` and `raw` hold then.
struct Command_options
{
  CLI::App& app;
  Arguments& arguments;
  Raw_arguments& raw;
};

// The type of the option must be `Integer`.
template <class Integer>
CLI::Validator integer(const Integer least)
{
  const std::string name = least > 0 ? "POSITIVE" : "NONNEGATIVE";
  return CLI::Validator(
    [=](std::string& text) {
      const std::optional<Integer> value = count_of<Integer>(text);
      if(!value || *value < least)
        return "'" + text + "' is not " + range_of_counts(least);
      text = std::to_string(*value); // leading zeros would mean octal numbers
      return std::string();
    },
    name, name);
}

CLI::Validator number(double least, double largest);

// An empty path, for example from an unset shell variable, is not the same as a missing option.
CLI::Validator path();

// Files or folders; not required.
template <class Value>
CLI::Option* add_path(CLI::App& app, const std::string& name, Value& value, const std::string& help)
{
  return app.add_option(name, value, help)->check(path());
}

inline CLI::Option* add_path(Command_options& o, const std::string& name, std::string& value,
                             const std::string& help)
{
  return add_path(o.app, name, value, help);
}

enum class Shapes { SURFACES, ALL };
void add_input(Command_options& o, Shapes shapes = Shapes::ALL);
// --output, and --format if it can have one of these.
void add_output(Command_options& o, const std::string& help,
                const std::vector<std::string>& formats = {});
void add_report(Command_options& o);
void add_quiet(Command_options& o);

void add_method_option(Command_options& o, const std::string& name);

// --stance, the name of one or a file.
void add_stance(Command_options& o);

// --geodesics, --threads, --quiet.
void add_common(Command_options& o);

void add_constraints(Command_options& o);

// The options of `pose` that `segment` and `describe` have as well.
void add_method_options(Command_options& o);

// The same, for commands that pose each component by default.
void add_method_options_for_each_component(Command_options& o);

// The same, and remembers those that matter for results and are not the default.
void add_recorded_method_options(Command_options& o);

// --pose, of those that need one.
void add_given_pose(Command_options& o);

CLI::Option* add_database(Command_options& o); // required
void add_weighted_descriptors(Command_options& o);

// The options of the library, with a visitor that tells the iterations of a watched run.
CGAL::Canonical_pose_3::Options watched_options(const Arguments& arguments);

// Converts what was parsed. Throws CLI::ValidationError.
void take(const Raw_arguments& raw, Arguments& arguments);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMMAND_OPTIONS_H
