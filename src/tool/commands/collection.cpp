// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command collection.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "descriptors.h"
#include "collection/Collection_database.h"
#include "collection/Shape_job.h"
#include "collection/run_jobs.h"
#include "formats/Mesh_file.h"
#include "formats/readers.h"

#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <boost/crc.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool is_of_surfaces(const std::string& extension)
{
  static const std::set<std::string> known = {".off", ".obj", ".ply", ".stl", ".glb", ".gltf"};
  return known.count(extension) > 0;
}

// The surfaces in a folder and its folders. Links are followed, but no folder is visited twice.
void add_folder(const fs::path& folder, std::set<fs::path>& visited, std::set<std::string>& paths)
{
  if(!visited.insert(fs::canonical(folder)).second)
    return;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    std::error_code error;
    if(fs::is_directory(entry.path(), error))
      add_folder(entry.path(), visited, paths);
    else if(is_of_surfaces(extension_of(entry.path().string())))
      paths.insert(entry.path().string());
  }
}

// The absolute path, with links as they are.
std::string normal_path(const std::string& path)
{
  return fs::absolute(path).lexically_normal().string();
}

void add_list(const std::string& list, std::set<std::string>& paths)
try
{
  for(const std::string& line : read_lines(list))
    if(!line.empty())
      paths.insert(normal_path(line));
}
catch(const std::invalid_argument& error)
{
  throw std::invalid_argument("the list '" + list + "' cannot be read: " + error.what());
}

// The shapes, without duplicates.
std::vector<std::string> shapes_of(const std::vector<std::string>& inputs)
{
  std::set<std::string> paths;
  std::set<fs::path> visited;
  for(const std::string& input : inputs)
  {
    std::error_code error;
    const std::size_t number_before = paths.size();
    if(input.front() == '@')
      add_list(input.substr(1), paths);
    else if(fs::is_directory(input, error))
      add_folder(normal_path(input), visited, paths);
    else if(fs::exists(input, error))
      paths.insert(normal_path(input));
    else
      throw std::invalid_argument("'" + input + "' does not exist");
    if(paths.size() == number_before && inputs.size() == 1)
      throw std::invalid_argument("there is no shape in '" + input + "'");
  }
  return {paths.begin(), paths.end()};
}

// The files beside a scene (.gltf) that it names.
std::vector<std::string> files_beside(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  const Json json = Json::parse(in, nullptr, false);
  std::vector<std::string> result;
  for(const char* const list : {"buffers", "images"})
    if(const auto found = json.find(list); found != json.end())
      for(const Json& entry : *found)
        if(entry.is_object() && entry.contains("uri") && entry["uri"].is_string())
        {
          const std::string name = decoded_uri(entry["uri"].get<std::string>());
          result.push_back((fs::path(path).parent_path() / name).string());
        }
  return result;
}

// The number of bytes and their cyclic redundancy check; empty if the file cannot be read.
std::string checksum_of(const std::string& path)
{
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, ~0ULL, ~0ULL, true, true> crc;
  std::uintmax_t size = 0;
  const auto add = [&](const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 1 << 16> part;
    while(in && in.read(part.data(), part.size()).gcount() > 0)
    {
      crc.process_bytes(part.data(), static_cast<std::size_t>(in.gcount()));
      size += static_cast<std::uintmax_t>(in.gcount());
    }
    return in.eof();
  };
  if(!add(path) && size == 0)
    return {};
  if(extension_of(path) == ".gltf")
    for(const std::string& file : files_beside(path))
      add(file);
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%ju-%016jx", size,
                static_cast<std::uintmax_t>(crc.checksum()));
  return text.data();
}

// In the format of the shape, so that nothing of it is lost.
std::string pose_file(const Arguments& arguments, const std::string& path)
{
  if(arguments.pose_folder.empty())
    return {};
  const std::string extension = extension_of(path);
  return (fs::absolute(arguments.pose_folder) / stem_of(path)).string()
         + (extension == ".gltf"        ? ".glb"
            : is_of_surfaces(extension) ? extension
                                        : ".off");
}

// Poses are named after the shapes.
void check_pose_files(const Arguments& arguments, const std::vector<std::string>& paths)
{
  std::map<std::string, std::string> path_of;
  for(const std::string& path : paths)
  {
    const std::string file = pose_file(arguments, path);
    if(const auto [other, is_new] = path_of.emplace(file, path); !is_new)
      throw std::invalid_argument("the poses of '" + other->second + "' and '" + path
                                  + "' would have the same name");
    if(is_same_file(file, path))
      throw std::invalid_argument("the pose of '" + path + "' would replace it");
  }
}

// A larger limit is reason to try again.
bool is_within(const double limit, const double limit_before)
{
  return limit_before == 0 || (limit > 0 && limit <= limit_before);
}

// What is still to be done for a shape, if anything.
std::optional<Shape_job> job_of(const std::string& path, const Arguments& arguments,
                                const std::vector<Descriptor>& requested,
                                Collection_database& database)
{
  Shape_job job;
  job.key = {path, checksum_of(path), arguments.pose_options, CGAL_CANONICAL_POSE_3_VERSION};
  job.limits = {arguments.time_limit, arguments.memory_limit};
  std::optional<Shape_row> row = database.row_of(path, job.key.options);
  if(!row && !job.key.checksum.empty() && database.take_moved(job.key))
    row = database.row_of(path, job.key.options);
  const bool is_current = row && row->key == job.key;
  const bool is_tried_again
    = is_current && (row->outcome == Outcome::CRASHED || row->outcome == Outcome::NOT_WRITTEN);
  if(is_current && row->outcome != Outcome::DONE && !is_tried_again
     && (row->outcome != Outcome::TIMED_OUT || is_within(arguments.time_limit, row->time_limit))
     && (row->outcome != Outcome::OUT_OF_MEMORY
         || is_within(arguments.memory_limit, row->memory_limit)))
    return std::nullopt;

  const bool is_done = is_current && row->outcome == Outcome::DONE;
  for(const Descriptor& descriptor : requested)
    if(!is_done
       || std::none_of(
         row->descriptors.begin(), row->descriptors.end(), [&](const Descriptor_values& values) {
           return values.name == descriptor.name && values.version == descriptor.version;
         }))
      job.descriptors.push_back(descriptor.name);
  const std::string pose = pose_file(arguments, path);
  if(!pose.empty() && (!is_done || row->pose.empty() || row->pose != checksum_of(pose)))
    job.pose = pose;
  job.is_segmented = arguments.is_segmented && (!is_done || row->parts.empty());
  if(job.descriptors.empty() && job.pose.empty() && !job.is_segmented)
    return std::nullopt;

  job.arguments
    = {"shape", path, "--quiet", "--threads", std::to_string(arguments.options.number_of_threads)};
  for(const std::string& name : job.descriptors)
    job.arguments.insert(job.arguments.end(), {"--descriptor", name});
  if(job.descriptors.empty())
    job.arguments.emplace_back("--no-descriptor");
  if(!job.pose.empty())
    job.arguments.insert(job.arguments.end(), {"-o", job.pose});
  if(job.is_segmented)
    job.arguments.emplace_back("--segment");
  job.arguments.insert(job.arguments.end(), arguments.pose_words.begin(),
                       arguments.pose_words.end());
  return job;
}

// The shapes that take the longest come first, so that no worker is left with one at the end.
void sort_by_size(std::vector<Shape_job>& jobs)
{
  const auto size_of
    = [](const Shape_job& job) { return std::strtoull(job.key.checksum.c_str(), nullptr, 10); };
  std::stable_sort(jobs.begin(), jobs.end(),
                   [&](const Shape_job& a, const Shape_job& b) { return size_of(a) > size_of(b); });
}

// Tells rate and time left.
class Progress
{
public:
  Progress(const std::size_t number_of_jobs, const Arguments& arguments)
    : m_number_of_jobs(number_of_jobs), m_arguments(arguments)
  {}
  ~Progress() { m_arguments.say(""); }

  void advance()
  {
    ++m_number_done;
    const double seconds
      = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    const double rate = static_cast<double>(m_number_done) / (std::max)(seconds, 1e-9);
    std::array<char, 80> text;
    std::snprintf(text.data(), text.size(), "%zu of %zu shapes, %.3g per second, %.0f s left",
                  m_number_done, m_number_of_jobs, rate,
                  static_cast<double>(m_number_of_jobs - m_number_done) / rate);
    m_arguments.say(text.data());
  }

private:
  std::size_t m_number_of_jobs, m_number_done = 0;
  const Arguments& m_arguments;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

// Outcome, path and message, with tabs between them.
std::string line_of(const Shape_row& row, const std::string& before_message = "")
{
  return name_of(row.outcome) + '\t' + row.key.path
         + (row.message.empty() && before_message.empty() ? ""
                                                          : '\t' + before_message + row.message)
         + '\n';
}

void write_summary(std::ostream& out, const std::vector<std::string>& paths,
                   const std::size_t number_of_jobs, const std::string& options,
                   Collection_database& database)
{
  std::map<Outcome, std::size_t> numbers;
  std::string failures;
  for(const std::string& path : paths)
    if(const auto row = database.row_of(path, options))
    {
      ++numbers[row->outcome];
      if(row->outcome != Outcome::DONE)
        failures += line_of(*row);
    }
  out << paths.size() << (paths.size() == 1 ? " shape, " : " shapes, ") << number_of_jobs
      << " computed now\n";
  for(const auto& [outcome, number] : numbers)
    out << std::left << std::setw(14) << name_of(outcome) << number << '\n';
  out << failures;
}

Json json_of(const Shape_row& row)
{
  Json descriptors = Json::object();
  for(const Descriptor_values& descriptor : row.descriptors)
    descriptors[descriptor.name] = descriptor.version;
  return {{"path", row.key.path},
          {"checksum", row.key.checksum},
          {"options", row.key.options},
          {"version", row.key.version},
          {"outcome", name_of(row.outcome)},
          {"message", row.message},
          {"seconds", row.seconds},
          {"has_pose", !row.pose.empty()},
          {"is_segmented", !row.parts.empty()},
          {"descriptors", descriptors},
          {"report", row.report.empty() ? Json() : Json::parse(row.report)}};
}

// All shapes of the database, or those without a result.
void list_collection(const Arguments& arguments)
{
  Collection_database database(arguments.database, false);
  Json all = Json::array();
  database.for_each_row([&](Shape_row& row) {
    if(arguments.are_failures_listed && row.outcome == Outcome::DONE)
      return;
    if(arguments.is_json)
    {
      database.complete(row);
      all.push_back(json_of(row));
    }
    else
      std::cout << line_of(row, row.key.options + '\t');
  });
  if(arguments.is_json)
    std::cout << all.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

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

// Every N-th shape, from the K-th one.
void keep_share(std::vector<std::string>& paths, const Arguments& arguments)
{
  std::vector<std::string> kept;
  for(std::size_t i = arguments.shard - 1; i < paths.size(); i += arguments.number_of_shards)
    kept.push_back(paths[i]);
  paths = std::move(kept);
}

void compute_collection(const Arguments& arguments, const Run_jobs& run_by_mpi)
{
  const std::vector<Descriptor> requested = descriptors(arguments.descriptors);
  std::vector<std::string> paths = shapes_of(arguments.inputs);
  if(!arguments.pose_folder.empty())
    check_pose_files(arguments, paths);
  keep_share(paths, arguments);
  if(!arguments.pose_folder.empty())
  {
    std::error_code error;
    fs::create_directory(arguments.pose_folder, error);
    if(error)
      throw std::invalid_argument("'" + arguments.pose_folder
                                  + "' cannot be created: " + error.message());
  }
  Collection_database database(arguments.database, true);
  arguments.say("comparing the files with the database");
  std::vector<Shape_job> jobs;
  for(const std::string& path : paths)
    if(auto job = job_of(path, arguments, requested, database))
      jobs.push_back(std::move(*job));
  sort_by_size(jobs);
  {
    Progress progress(jobs.size(), arguments);
    const auto ended = [&](const Shape_job& job, const Child_process::Ending& ending) {
      Shape_row row = job.row_of(ending);
      if(row.outcome == Outcome::DONE && !job.pose.empty())
        row.pose = checksum_of(job.pose);
      database.write(row);
      progress.advance();
    };
    if(run_by_mpi)
      run_by_mpi(jobs, ended);
    else
      run_jobs(jobs,
               arguments.number_of_workers > 0
                 ? arguments.number_of_workers
                 : (std::max<std::size_t>)(std::thread::hardware_concurrency(), 1),
               ended);
  }
  if(!arguments.quiet)
    write_summary(std::cout, paths, jobs.size(), arguments.pose_options, database);
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

int run_collection(Arguments& arguments)
{
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
      "collection --list --failed --database meshes.db",
      "collection meshes/ --database part_3.db --shard 3/10",
      "collection merge part_1.db part_2.db -o meshes.db"},
     add_collection_options,
     run_collection};

} // namespace Canonical_pose_tool
