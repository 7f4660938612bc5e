// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shape_job.h"
#include "formats/Mesh_file.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <exception>

namespace Canonical_pose_tool {

namespace {

using Json = nlohmann::ordered_json;

// The line that the tool writes about a failure, without its own name and that of the file.
std::string message_in(const std::string& errors, const std::string& path)
{
  std::string line = errors.substr(0, errors.find('\n'));
  for(const std::string& prefix : {std::string("canonical-pose: "), name_of_input(path) + ": "})
    if(line.rfind(prefix, 0) == 0)
      line.erase(0, prefix.size());
  return line;
}

void take_results(const std::string& output, Shape_row& row)
{
  const Json json = Json::parse(output);
  row.report = json.at("report").dump();
  for(const auto& [name, descriptor] : json.at("descriptors").items())
  {
    const auto values = descriptor.at("values").get<std::vector<double>>();
    row.descriptors.push_back(
      {name, descriptor.at("version").get<int>(),
       Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()))});
  }
  row.parts = json.at("parts").get<std::vector<int>>();
}

void take_match(const std::string& report, Shape_row& row)
{
  const Json json = Json::parse(report);
  Json match;
  for(const char* const key :
      {"mean_distance", "mean_round_trip", "is_rotation_certain", "warnings"})
    match[key] = json.at(key);
  match["seconds"] = row.seconds;
  row.match = match.dump();
}

} // namespace

Shape_row Shape_job::row_of(const Child_process::Ending& ending) const
{
  Shape_row row;
  row.key = key;
  row.seconds = ending.seconds;
  row.time_limit = limits.seconds;
  row.memory_limit = limits.megabytes;
  row.message = message_in(ending.errors, key.path);
  if(ending.timed_out)
  {
    row.outcome = Outcome::TIMED_OUT;
    row.message = "not done after " + Json(limits.seconds).dump() + " seconds";
  }
  else if(ending.out_of_memory)
  {
    row.outcome = Outcome::OUT_OF_MEMORY;
    row.message = "more than " + Json(limits.megabytes).dump() + " megabytes are needed";
  }
  else if(ending.signal != 0)
  {
    row.outcome = Outcome::CRASHED;
    row.message = std::string("ended by a signal: ") + strsignal(ending.signal);
  }
  else if(ending.exit_code != 0)
  {
    const auto says
      = [&](const char* const text) { return row.message.find(text) != std::string::npos; };
    row.outcome = says("out of memory") || says("not enough memory") ? Outcome::OUT_OF_MEMORY
                  : says(" cannot be written: ")                     ? Outcome::NOT_WRITTEN
                  : row.message.empty()                              ? Outcome::CRASHED
                                                                     : Outcome::REFUSED;
    if(row.message.empty())
      row.message = "ended without a message";
  }
  else
    try
    {
      if(match.empty())
        take_results(ending.output, row);
      else
        take_match(ending.output, row);
      row.message.clear();
    }
    catch(const Json::exception& error)
    {
      row.outcome = Outcome::CRASHED;
      row.message = std::string("ended without a result: ") + error.what();
      row.descriptors.clear();
    }
  return row;
}

std::string to_text(const std::vector<std::string>& arguments, const Child_process::Limits& limits)
{
  return Json{
    {"arguments", arguments}, {"seconds", limits.seconds}, {"megabytes", limits.megabytes}}
    .dump(-1, ' ', false, Json::error_handler_t::replace);
}

void from_text(const std::string& text, std::vector<std::string>& arguments,
               Child_process::Limits& limits)
{
  const Json json = Json::parse(text);
  arguments = json.at("arguments").get<std::vector<std::string>>();
  limits = {json.at("seconds").get<double>(), json.at("megabytes").get<double>()};
}

std::string to_text(const Child_process::Ending& ending)
{
  return Json{{"exit_code", ending.exit_code}, {"signal", ending.signal},
              {"timed_out", ending.timed_out}, {"out_of_memory", ending.out_of_memory},
              {"output", ending.output},       {"errors", ending.errors},
              {"seconds", ending.seconds}}
    .dump(-1, ' ', false, Json::error_handler_t::replace);
}

Child_process::Ending ending_from_text(const std::string& text)
{
  const Json json = Json::parse(text);
  Child_process::Ending result;
  result.exit_code = json.at("exit_code").get<int>();
  result.signal = json.at("signal").get<int>();
  result.timed_out = json.at("timed_out").get<bool>();
  result.out_of_memory = json.at("out_of_memory").get<bool>();
  result.output = json.at("output").get<std::string>();
  result.errors = json.at("errors").get<std::string>();
  result.seconds = json.at("seconds").get<double>();
  return result;
}

} // namespace Canonical_pose_tool
