// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command collection.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "collection/Collection_database.h"
#include "collection/collected_shapes.h"
#include "collection/compute_collection.h"
#include "collection/list_collection.h"
#include "collection/run_jobs.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

void merge_collections(const Arguments& arguments)
{
  std::vector<std::unique_ptr<Collection_database>> inputs;
  std::vector<Collection_database*> others;
  for(const std::string& input : arguments.inputs)
  {
    if(is_same_file(input, arguments.output))
      throw std::invalid_argument("'" + input + "' is merged into itself; name only the others");
    inputs.push_back(std::make_unique<Collection_database>(input, false));
    others.push_back(inputs.back().get());
  }
  std::error_code error;
  const bool is_new = !fs::exists(arguments.output, error);
  try
  {
    Collection_database(arguments.output, true).merge(others);
  }
  catch(...)
  {
    if(is_new)
      fs::remove(arguments.output, error);
    throw;
  }
}

void add_collection_options(Command_options& o)
{
  // Not required, or CLI11 would take "merge" for an input.
  CLI::Option* const input
    = o.app.add_option("INPUT", o.arguments.inputs,
                       "surfaces, folders with surfaces, and @lists of paths, one per line");
  input->check(path());
  CLI::Option* const database = add_database(o);
  CLI::Option* const list
    = o.app.add_flag("--list", o.arguments.is_listed,
                     "compute nothing, but print outcome, path, options and message of all shapes");
  list->excludes(input);
  o.app.add_flag("--failed", o.arguments.are_failures_listed, "list only shapes without a result")
    ->needs(list);
  o.app.add_flag("--json", o.arguments.is_json, "list as JSON, with the reports")->needs(list);
  o.app
    .add_option("--descriptor", o.arguments.descriptors,
                "a descriptor, as in describe; may be repeated; default: all")
    ->allow_extra_args(false);
  add_path(o, "--poses", o.arguments.pose_folder,
           "folder for the poses, in the formats of the shapes");
  CLI::Option* const match = add_path(o, "--match", o.arguments.match_template,
                                      "a surface that is matched with each shape");
  CLI::Option* const matches
    = add_path(o, "--matches", o.arguments.match_folder,
               "folder for this surface in the shape of each one; its poses are in 'poses' there");
  match->needs(matches);
  matches->needs(match);
  o.app.add_flag("--segment", o.arguments.is_segmented, "also divide the shapes into parts");
  o.app
    .add_option("--workers", o.arguments.number_of_workers,
                "number of shapes computed at the same time; 0: one per processor")
    ->transform(integer(std::size_t(0)))
    ->capture_default_str();
  o.app
    .add_option_function<std::string>(
      "--shard",
      [&arguments = o.arguments](const std::string& text) {
        const std::size_t slash = (std::min)(text.find('/'), text.size());
        const auto k = count_of<std::size_t>(text.substr(0, slash)),
                   n = count_of<std::size_t>(text.substr((std::min)(slash + 1, text.size())));
        if(!k || !n || *k < 1 || *k > *n)
          throw CLI::ValidationError("--shard", "'" + text + "' is not K/N with K from 1 to N");
        arguments.shard = *k;
        arguments.number_of_shards = *n;
      },
      "K/N: only the K-th of N shares of the shapes, for jobs with a database each")
    ->excludes(list);
  o.app.add_option("--time-limit", o.arguments.time_limit, "seconds per shape; 0: no limit")
    ->check(number(0, 1e9))
    ->capture_default_str();
  o.app
    .add_option("--memory-limit", o.arguments.memory_limit,
                "megabytes of resident memory per shape; 0: no limit")
    ->check(number(0, 1e9))
    ->capture_default_str();
  o.arguments.options.number_of_threads = 1; // per shape
  add_recorded_method_options(o);

  CLI::App* const merge = o.app.add_subcommand("merge", "joins databases");
  add_path(*merge, "INPUT", o.arguments.inputs, "databases")->required();
  add_path(*merge, "-o,--output", o.arguments.output, "the database to which their rows are added")
    ->required();
  merge->excludes(input)->excludes(list)->preparse_callback(
    [database, &arguments = o.arguments](std::size_t) {
      arguments.is_merged = true;
      database->required(false);
    });
}

// Matches take poses.
void set_folders(Arguments& arguments)
{
  if(arguments.match_template.empty())
    return;
  arguments.match_template = normal_path(arguments.match_template);
  if(arguments.pose_folder.empty())
    arguments.pose_folder = (fs::path(arguments.match_folder) / "poses").string();
  const auto place
    = [](const std::string& folder) { return fs::weakly_canonical(fs::absolute(folder) / ""); };
  if(place(arguments.pose_folder) == place(arguments.match_folder))
    throw Usage_error("--poses and --matches must be different folders");
}

int run_collection(Arguments& arguments)
{
  set_folders(arguments);
  if(arguments.is_merged)
    merge_collections(arguments);
  else if(arguments.is_listed)
    list_collection(arguments);
  else if(arguments.inputs.empty())
    throw Usage_error("INPUT is required; see --help");
  else
    with_mpi([&](const Run_jobs& run) { compute_collection(arguments, run); });
  return EXIT_SUCCESS;
}

} // namespace

const Command COLLECTION_COMMAND
  = {"collection",
     "describes many surfaces and stores the results in a database",
     {"collection meshes/ --database meshes.db",
      "collection @paths.txt --database meshes.db --poses poses/ --time-limit 600",
      "collection scans/ --database scans.db --match template.obj --matches matched/",
      "collection --list --failed --database meshes.db",
      "collection meshes/ --database part_3.db --shard 3/10",
      "collection merge part_1.db part_2.db -o meshes.db"},
     add_collection_options,
     run_collection};

} // namespace Canonical_pose_tool
