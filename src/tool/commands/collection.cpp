// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command collection.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "descriptors.h"
#include "collection/Collection_database.h"
#include "collection/Shape_job.h"
#include "collection/pose_of_template.h"
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

// Named after a shape, in the format of a file that is a surface.
std::string output_file(const std::string& folder, const std::string& shape,
                        const std::string& file)
{
  const std::string extension = extension_of(file);
  return (fs::absolute(folder) / stem_of(shape)).string()
         + (extension == ".gltf"        ? ".glb"
            : is_of_surfaces(extension) ? extension
                                        : ".off");
}

// In the format of the shape, so that nothing of it is lost.
std::string pose_file(const Arguments& arguments, const std::string& path)
{
  return arguments.pose_folder.empty() ? "" : output_file(arguments.pose_folder, path, path);
}

// The template in the shape of `path`.
std::string match_file(const Arguments& arguments, const std::string& path)
{
  return output_file(arguments.match_folder, path, arguments.match_template);
}

// Poses and matches are named after the shapes.
void check_output_files(const Arguments& arguments, const std::vector<std::string>& paths)
{
  std::map<std::string, std::string> path_of;
  const auto check = [&](const std::string& file, const std::string& path,
                         const std::string& singular, const std::string& plural) {
    const std::string other = path_of.emplace(file, path).first->second;
    if(other != path)
      throw std::invalid_argument("the " + plural + " of '" + other + "' and '" + path
                                  + "' would have the same name");
    for(const std::string& input : {path, arguments.match_template})
      if(!input.empty() && is_same_file(file, input))
        throw std::invalid_argument("the " + singular + " of '" + path + "' would replace "
                                    + (input == path ? "it" : "'" + input + "'"));
  };
  const bool has_matches = !arguments.match_template.empty();
  for(const std::string& path : paths)
  {
    if(!arguments.pose_folder.empty())
      check(pose_file(arguments, path), path, "pose", "poses");
    if(has_matches)
      check(match_file(arguments, path), path, "match", "matches");
  }
  if(has_matches)
    check(pose_file(arguments, arguments.match_template), arguments.match_template, "pose",
          "poses");
}

// A larger limit is reason to try again.
bool is_within(const double limit, const double limit_before)
{
  return limit_before == 0 || (limit > 0 && limit <= limit_before);
}

// Whether a match is, or has failed, with this template.
bool has_template(const Json& match, const std::string& checksum)
{
  return match.is_object() && match.value("template_checksum", "") == checksum;
}

// What is still to be done for a shape, if anything, but for its match.
std::optional<Shape_job> job_of(const std::string& path, const Arguments& arguments,
                                const std::vector<Descriptor>& requested,
                                const std::string& checksum_of_template,
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
    = is_current
      && (row->outcome == Outcome::CRASHED || row->outcome == Outcome::NOT_WRITTEN
          || (!row->match.empty() && !has_template(Json::parse(row->match), checksum_of_template)));
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

// The match of a shape that has a pose, unless it is up to date.
std::optional<Shape_job> match_job_of(const std::string& path, const Arguments& arguments,
                                      const std::string& checksum_of_template,
                                      Collection_database& database)
{
  const std::optional<Shape_row> row = database.row_of(path, arguments.pose_options);
  if(!row || row->outcome != Outcome::DONE)
    return std::nullopt;
  Shape_job job;
  job.key = row->key;
  job.limits = {arguments.time_limit, arguments.memory_limit};
  job.match = match_file(arguments, path);
  if(const Json match = Json::parse(row->match, nullptr, false);
     has_template(match, checksum_of_template)
     && match.value("checksum", "none") == checksum_of(job.match))
    return std::nullopt;
  job.arguments = {"match",
                   arguments.match_template,
                   path,
                   "-o",
                   job.match,
                   "--pose",
                   pose_file(arguments, arguments.match_template),
                   "--other-pose",
                   pose_file(arguments, path),
                   "--report",
                   "-",
                   "--quiet",
                   "--threads",
                   std::to_string(arguments.options.number_of_threads)};
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
  Progress(const std::size_t number_of_jobs, std::string name, const Arguments& arguments)
    : m_number_of_jobs(number_of_jobs), m_name(std::move(name)), m_arguments(arguments)
  {}
  ~Progress() { m_arguments.say(""); }

  void advance()
  {
    ++m_number_done;
    const double seconds
      = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    const double rate = static_cast<double>(m_number_done) / (std::max)(seconds, 1e-9);
    std::array<char, 80> text;
    std::snprintf(text.data(), text.size(), "%zu of %zu %s, %.3g per second, %.0f s left",
                  m_number_done, m_number_of_jobs, m_name.c_str(), rate,
                  static_cast<double>(m_number_of_jobs - m_number_done) / rate);
    m_arguments.say(text.data());
  }

private:
  std::size_t m_number_of_jobs, m_number_done = 0;
  std::string m_name;
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
                   const std::size_t number_computed, const std::string& options,
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
  out << paths.size() << (paths.size() == 1 ? " shape, " : " shapes, ") << number_computed
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
  Json report = row.report.empty() ? Json() : Json::parse(row.report);
  if(report.is_object() && !row.match.empty())
    report["match"] = Json::parse(row.match);
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
          {"report", report}};
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

void create_folder(const std::string& folder)
{
  std::error_code error;
  if(!folder.empty())
    fs::create_directory(folder, error);
  if(error)
    throw std::invalid_argument("'" + folder + "' cannot be created: " + error.message());
}

// Computes shapes and writes their rows.
class Computation
{
public:
  Computation(const Arguments& arguments, const Run_jobs& run_by_mpi, Collection_database& database)
    : m_arguments(arguments), m_database(database), m_run(run_by_mpi)
  {
    if(!m_run)
      m_run = [&arguments](const std::vector<Shape_job>& jobs, const Job_ended& ended) {
        run_jobs(jobs,
                 arguments.number_of_workers > 0
                   ? arguments.number_of_workers
                   : (std::max<std::size_t>)(std::thread::hardware_concurrency(), 1),
                 ended);
      };
  }

  void run(std::vector<Shape_job>& jobs, const std::string& name,
           const std::string& checksum_of_template)
  {
    sort_by_size(jobs);
    Progress progress(jobs.size(), name, m_arguments);
    m_run(jobs, [&](const Shape_job& job, const Child_process::Ending& ending) {
      Shape_row row = job.row_of(ending);
      if(row.outcome == Outcome::DONE && !job.pose.empty())
        row.pose = checksum_of(job.pose);
      if(!job.match.empty())
        add_template(job, checksum_of_template, row);
      m_database.write(row);
      m_computed.insert(job.key.path);
      progress.advance();
    });
  }

  std::size_t number_computed() const { return m_computed.size(); }

private:
  // What the match depends on, also if it has failed.
  void add_template(const Shape_job& job, const std::string& checksum, Shape_row& row) const
  {
    Json match = row.match.empty() ? Json::object() : Json::parse(row.match);
    match["template"] = m_arguments.match_template;
    match["template_checksum"] = checksum;
    if(row.outcome == Outcome::DONE)
      match["checksum"] = checksum_of(job.match);
    row.match = match.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  const Arguments& m_arguments;
  Collection_database& m_database;
  Run_jobs m_run;
  std::set<std::string> m_computed;
};

void compute_collection(const Arguments& arguments, const Run_jobs& run_by_mpi)
{
  const std::vector<Descriptor> requested = descriptors(arguments.descriptors);
  const bool has_matches = !arguments.match_template.empty();
  std::vector<std::string> paths = shapes_of(arguments.inputs);
  check_output_files(arguments, paths);
  const std::string checksum_of_template = has_matches ? checksum_of(arguments.match_template) : "";
  if(has_matches && checksum_of_template.empty())
    throw std::invalid_argument("the template '" + arguments.match_template + "' cannot be read");
  keep_share(paths, arguments);
  create_folder(arguments.match_folder);
  create_folder(arguments.pose_folder);
  Collection_database database(arguments.database, true);
  arguments.say("comparing the files with the database");
  std::vector<Shape_job> jobs;
  for(const std::string& path : paths)
    if(auto job = job_of(path, arguments, requested, checksum_of_template, database))
      jobs.push_back(std::move(*job));
  std::vector<Shape_job> match_jobs;
  const auto add_match_jobs = [&] {
    for(const std::string& path : paths)
      if(auto job = match_job_of(path, arguments, checksum_of_template, database))
        match_jobs.push_back(std::move(*job));
  };
  if(has_matches && jobs.empty())
    add_match_jobs();
  // First, so that a template which cannot be used is noticed at once.
  if(has_matches && !(jobs.empty() && match_jobs.empty()))
    write_pose_of_template(arguments, pose_file(arguments, arguments.match_template));
  Computation computation(arguments, run_by_mpi, database);
  computation.run(jobs, "shapes", checksum_of_template);
  if(has_matches && !jobs.empty())
    add_match_jobs();
  computation.run(match_jobs, "matches", checksum_of_template);
  if(!arguments.quiet)
    write_summary(std::cout, paths, computation.number_computed(), arguments.pose_options,
                  database);
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
