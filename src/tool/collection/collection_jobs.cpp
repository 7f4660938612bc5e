// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a collection still has to compute.

#include "collection/collection_jobs.h"
#include "Output_files.h"
#include "collection/collected_shapes.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

// The template in the shape of `path`.
std::string match_file(const Arguments& arguments, const std::string& path)
{
  return output_file(arguments.match_folder, path, arguments.match_template);
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

} // namespace

std::string pose_file(const Arguments& arguments, const std::string& path)
{
  return arguments.pose_folder.empty() ? "" : output_file(arguments.pose_folder, path, path);
}

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

} // namespace Canonical_pose_tool
