// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_options.h"
#include "exact_geodesics.h"
#include "method_options.h"
#include "formats/Mesh_file.h"
#include "formats/Shortest_numbers.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Splits "1,2,0.5" at the commas; there must be from `least` to `most` numbers.
std::vector<std::string> words(const std::string& option, const std::string& text,
                               const std::size_t least, const std::size_t most)
{
  std::vector<std::string> result;
  for(std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(',', begin);
    result.push_back(text.substr(begin, end - begin));
    if(!real_of(result.back()))
      throw CLI::ValidationError(option, "'" + text
                                           + "' is not a list of numbers with commas between them");
  }
  if(result.size() < least || result.size() > most)
    throw CLI::ValidationError(option, "'" + text + "' has a wrong number of values");
  return result;
}

std::string shown(const double number)
{
  std::ostringstream out;
  out << number;
  return out.str();
}

// Defines a constraint: vertices, then numbers, then optionally a stiffness.
struct Constraint_values
{
  Constraint_values(const std::string& option, const std::string& text,
                    const std::size_t number_of_vertices, const std::size_t number_of_numbers)
  {
    const std::size_t n = number_of_vertices + number_of_numbers;
    const std::vector<std::string> all = words(option, text, n, n + 1);
    for(std::size_t i = 0; i < number_of_vertices; ++i)
    {
      const auto vertex = count_of<std::size_t>(all[i]);
      if(!vertex)
        throw CLI::ValidationError(
          option, "'" + text + "' does not begin with "
                    + (number_of_vertices == 2 ? "two vertex numbers" : "a vertex number"));
      vertices.push_back(*vertex);
    }
    for(std::size_t i = number_of_vertices; i < n; ++i)
      rest.push_back(*real_of(all[i]));
    if(all.size() > n)
      stiffness = *real_of(all.back());
    constexpr double least = Registration_options::SMALLEST_WEIGHT,
                     largest = Registration_options::LARGEST_WEIGHT;
    if(stiffness < least || stiffness > largest)
      throw CLI::ValidationError(option, "'" + text + "' has a stiffness that is not from "
                                           + shown(least) + " to " + shown(largest));
  }

  Eigen::RowVector3d vector() const { return {rest[0], rest[1], rest[2]}; }

  std::vector<std::size_t> vertices;
  std::vector<double> rest;
  double stiffness = 1;
};

void take_constraints(const Raw_arguments& raw, Options& options)
{
  for(const std::string& text : raw.springs)
  {
    const Constraint_values v("--spring", text, 2, 1);
    options.constraints.springs.push_back({v.vertices[0], v.vertices[1], v.rest[0], v.stiffness});
  }
  for(const std::string& text : raw.directions)
  {
    const Constraint_values v("--direction", text, 2, 3);
    options.constraints.directions.push_back(
      {v.vertices[0], v.vertices[1], v.vector(), v.stiffness});
  }
  for(const std::string& text : raw.handles)
  {
    const Constraint_values v("--handle", text, 1, 3);
    options.constraints.handles.push_back({v.vertices[0], v.vector(), v.stiffness});
  }
  for(const std::string& text : raw.symmetric_pairs)
  {
    const Constraint_values v("--symmetric", text, 2, 0);
    options.constraints.symmetric_pairs.push_back({v.vertices[0], v.vertices[1], v.stiffness});
  }
}

// The same text for the same number.
std::string as_value(const std::string& text)
{
  if(const auto count = count_of<unsigned long long>(text))
    return std::to_string(*count);
  const std::optional<double> number = real_of(text);
  if(!number)
    return text;
  std::ostringstream out;
  use_shortest_numbers(out);
  out << *number;
  return out.str();
}

} // namespace

CLI::Validator number(const double least, const double largest)
{
  const std::string name = least > 0 ? "POSITIVE" : "NONNEGATIVE";
  return CLI::Validator(
    [=](const std::string& text) {
      const std::optional<double> value = real_of(text);
      return value && *value >= least && *value <= largest
               ? std::string()
               : "'" + text + "' is not a number from " + shown(least) + " to " + shown(largest);
    },
    name, name);
}

CLI::Validator path()
{
  return CLI::Validator(
    [](const std::string& text) { return text.empty() ? "the path is empty" : std::string(); },
    "PATH");
}

void add_input(Command_options& o, const Shapes shapes)
{
  add_path(o, "INPUT", o.arguments.input,
           std::string("surface (.off, .obj, .ply, .stl, .glb, .gltf)")
             + (shapes == Shapes::SURFACES ? "" : " or tetrahedral mesh (MEDIT, .mesh)"))
    ->required();
}

void add_output(Command_options& o, const std::string& help,
                const std::vector<std::string>& formats)
{
  add_path(o, "-o,--output", o.arguments.output, help)->required();
  if(formats.empty())
    return;
  o.app
    .add_option("--format", o.raw.format,
                "format of OUTPUT if that is the standard output (-): "
                  + boost::algorithm::join(formats, ", "))
    ->check(CLI::IsMember(formats));
}

void add_report(Command_options& o)
{
  add_path(o, "--report", o.arguments.report, "also write a report (JSON)");
}

void add_quiet(Command_options& o)
{
  o.app.add_flag("--quiet", o.arguments.quiet, "print nothing but errors");
}

void add_method_option(Command_options& o, const std::string& name)
{
  const Method_option& option = method_option(name);
  Options& options = o.arguments.options;
  CLI::Option* const added = o.app.add_option_function<std::string>(
    "--" + name, [&option, &options](const std::string& text) { option.set(options, text); },
    option.help);
  if(option.type == Method_option::Type::CHOICE)
    added->check(CLI::IsMember(option.choices));
  else
  {
    const auto check = [&option](const std::string& text) {
      Options any;
      return option.set(any, text) ? std::string() : "'" + text + "' is not " + option.range;
    };
    added->check(CLI::Validator(check, check("0").empty() ? "NONNEGATIVE" : "POSITIVE"))
      ->type_name(option.type == Method_option::Type::INTEGER ? "INT" : "FLOAT");
  }
  Options any;
  if(const std::string value = option.value(options); option.set(any, value))
    added->default_str(value);
}

void add_stance(Command_options& o)
{
  const Method_option& option = method_option("stance");
  Arguments& arguments = o.arguments;
  const auto is_name = [&option](const std::string& text) {
    Options any;
    return option.set(any, text);
  };
  const auto check = [=, &option](const std::string& text) {
    return is_name(text) || std::filesystem::exists(text)
             ? std::string()
             : "'" + text + "' is neither " + option.range + " nor a file";
  };
  o.app
    .add_option_function<std::string>(
      "--stance",
      [is_name, &option, &arguments](const std::string& text) {
        if(is_name(text))
          option.set(arguments.options, text);
        else
          arguments.stance_file = text;
      },
      option.help + "; or a file that says where limbs go")
    ->check(CLI::Validator(check, '{' + boost::algorithm::join(option.choices, ",") + "},FILE"))
    ->default_str(option.value(arguments.options));
}

void add_common(Command_options& o)
{
  o.app.add_option("--geodesics", o.arguments.geodesics, "method of measuring geodesic distances")
    ->check(CLI::IsMember({"heat", "wavefront", "exact"}))
    ->capture_default_str();
  add_method_option(o, "threads");
  add_quiet(o);
}

void add_constraints(Command_options& o)
{
  const auto add = [&](const char* const name, std::vector<std::string>& texts, const char* help) {
    o.app.add_option(name, texts, std::string(help) + "; may be repeated")->allow_extra_args(false);
  };
  add("--spring", o.raw.springs, "I,J,LENGTH[,STIFFNESS]: a spring between two vertices");
  add("--direction", o.raw.directions,
      "I,J,X,Y,Z[,STIFFNESS]: the vector to one vertex from another");
  add("--handle", o.raw.handles, "I,X,Y,Z[,STIFFNESS]: the position of a vertex");
  add("--symmetric", o.raw.symmetric_pairs, "I,J[,STIFFNESS]: two vertices that mirror each other");
}

void add_method_options(Command_options& o)
{
  for(const Method_option& option : method_options())
    if(option.name != "threads" && option.name != "stance" && option.name != "frame")
      add_method_option(o, option.name);
  Options& options = o.arguments.options;
  o.app.add_option("--paper-weights", o.raw.paper_weights,
                   "ALPHA,BETA: the weights as the paper prints them");
  o.app.add_flag_callback(
    "--injective", [&options] { options.registration.injective = true; },
    "no inverted cells in the elastic body; the default, except with --paper-weights");
  o.app
    .add_flag_callback(
      "--no-injective", [&options] { options.registration.injective = false; },
      "inverted cells are allowed")
    ->excludes("--injective");
  add_common(o);
}

void add_method_options_for_each_component(Command_options& o)
{
  o.arguments.options.components = Options::Components::EACH;
  add_method_options(o);
}

void add_recorded_method_options(Command_options& o)
{
  const std::size_t number_before = o.app.get_options().size();
  add_method_options_for_each_component(o);
  CLI::App& app = o.app;
  Arguments& arguments = o.arguments;
  app.final_callback([&app, &arguments, number_before] {
    const std::vector<CLI::Option*> options = app.get_options();
    for(std::size_t i = number_before; i < options.size(); ++i)
    {
      const CLI::Option& option = *options[i];
      const std::string name = option.get_name();
      if(option.count() == 0 || name == "--threads" || name == "--quiet"
         || (name == "--injective" && app.count("--paper-weights") == 0)) // the default
        continue;
      if(option.get_expected_max() == 0)
        arguments.pose_words.push_back(name);
      else if(const std::string value = as_value(option.results().front());
              value != as_value(option.get_default_str()))
        arguments.pose_words.insert(arguments.pose_words.end(), {name, value});
    }
    for(const std::string& word : arguments.pose_words)
      arguments.pose_options += (arguments.pose_options.empty() ? "" : " ") + word;
  });
}

void add_given_pose(Command_options& o)
{
  add_path(o, "--pose", o.arguments.pose, "take this pose instead of computing one");
}

CLI::Option* add_database(Command_options& o)
{
  return add_path(o, "--database", o.arguments.database, "the collection (SQLite)")->required();
}

void add_weighted_descriptors(Command_options& o)
{
  const auto weight
    = number(Registration_options::SMALLEST_WEIGHT, Registration_options::LARGEST_WEIGHT);
  o.app
    .add_option("--descriptor", o.arguments.descriptors,
                "NAME[:WEIGHT], as in describe; may be repeated; default: all of the collection")
    ->allow_extra_args(false)
    ->check([=](const std::string& text) {
      const std::size_t colon = text.rfind(':');
      return colon == std::string::npos ? std::string() : weight(text.substr(colon + 1));
    });
}

Options watched_options(const Arguments& arguments)
{
  Options options = arguments.options;
  if(arguments.is_watched)
    options.visitor = [&arguments](const CGAL::Canonical_pose_3::Registration_progress& progress) {
      const std::string stage
        = progress.round > 0 ? "round " + std::to_string(progress.round) : "pose";
      char text[80];
      std::snprintf(text, sizeof(text), ", iteration %d, energy %.6g, largest move %.2g of L",
                    progress.iteration, progress.energy, progress.largest_move);
      arguments.say(stage + text);
      return true;
    };
  return options;
}

void take(const Raw_arguments& raw, Arguments& arguments)
{
  Options& options = arguments.options;
  set_geodesics(options, arguments.geodesics);
  if(!raw.paper_weights.empty())
  {
    const std::vector<std::string> weights = words("--paper-weights", raw.paper_weights, 2, 2);
    const double alpha = *real_of(weights[0]), beta = *real_of(weights[1]);
    if(!(alpha > 0) || beta < 0 || beta > Registration_options::LARGEST_WEIGHT)
      throw CLI::ValidationError("--paper-weights",
                                 "'" + raw.paper_weights
                                   + "': ALPHA must be positive, and BETA from 0 to "
                                   + shown(Registration_options::LARGEST_WEIGHT));
    options.paper_weights = CGAL::Canonical_pose_3::Paper_weights{alpha, beta};
  }
  if(options.target_mode == Options::Target_mode::UNFOLDING && !arguments.given_target.empty())
    throw CLI::ValidationError("--target-mode", "unfold excludes --given-target");
  if(!raw.format.empty())
  {
    if(arguments.output != "-")
      throw CLI::ValidationError("--format", "the output is a file, whose extension is its format");
    if(raw.format != "txt")
      arguments.output += '.' + raw.format;
  }
  take_constraints(raw, options);
  for(const std::string& text : raw.landmarks)
  {
    const std::size_t comma = text.find(',');
    const auto first = count_of<std::size_t>(text.substr(0, comma)),
               second
               = count_of<std::size_t>(comma == std::string::npos ? "" : text.substr(comma + 1));
    if(!first || !second)
      throw CLI::ValidationError(
        "--landmark", "'" + text + "' is not two vertex numbers with a comma between them");
    arguments.match.landmarks.emplace_back(*first, *second);
  }
  if(raw.parts != "auto")
  {
    arguments.number_of_parts = count_of<std::size_t>(raw.parts).value_or(0);
    if(arguments.number_of_parts == 0)
      throw CLI::ValidationError("--parts",
                                 "'" + raw.parts + "' is neither auto nor a positive number");
  }
  if(arguments.method == "kmeans" && arguments.number_of_parts == 0)
    throw CLI::ValidationError("--method", "'kmeans' cannot determine the number of parts: --parts "
                                           "is required");
}

} // namespace Canonical_pose_tool
