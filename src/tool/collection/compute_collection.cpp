// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/compute_collection.h"
#include "descriptors.h"
#include "collection/Collection_database.h"
#include "collection/Shape_job.h"
#include "collection/collected_shapes.h"
#include "collection/collection_jobs.h"
#include "collection/list_collection.h"
#include "collection/pose_of_template.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
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

} // namespace

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

} // namespace Canonical_pose_tool
