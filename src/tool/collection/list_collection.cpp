// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/list_collection.h"
#include "shown_results.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using Json = nlohmann::ordered_json;

// Outcome, path, options if they are shown, and message, with tabs between them.
std::string line_of(const Shape_row& row, const bool has_options = false)
{
  return name_of(row.outcome) + '\t' + in_one_line(row.key.path)
         + (has_options ? '\t' + in_one_line(row.key.options) : "")
         + (row.message.empty() && !has_options ? "" : '\t' + in_one_line(row.message)) + '\n';
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

// Those that contain one of these texts.
std::vector<std::string> warnings_in(const std::string& json, const std::vector<std::string>& texts)
{
  const Json report = Json::parse(json, nullptr, false);
  std::vector<std::string> result;
  if(report.is_object() && report.contains("warnings"))
    for(const std::string& warning : report["warnings"].get<std::vector<std::string>>())
      if(std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
           return warning.find(text) != std::string::npos;
         }))
        result.push_back(warning);
  return result;
}

} // namespace

std::string in_one_line(const std::string& text)
{
  std::string result;
  for(const char c : text)
    result += c == '\n'   ? "\\n"
              : c == '\r' ? "\\r"
              : c == '\t' ? "\\t"
              : c == '\\' ? "\\\\"
                          : std::string(1, c);
  return result;
}

void write_summary(std::ostream& out, const std::vector<std::string>& paths,
                   const std::size_t number_computed, const std::string& options,
                   Collection_database& database)
{
  std::map<Outcome, std::size_t> numbers;
  std::string failures, warnings;
  for(const std::string& path : paths)
    if(auto row = database.row_of(path, options))
    {
      ++numbers[row->outcome];
      if(row->outcome != Outcome::DONE)
        failures += line_of(*row);
      else
      {
        const auto add = [&](const std::string& warning) {
          warnings += "warning: " + in_one_line(path + ": " + warning) + '\n';
        };
        if(!row->pose.empty()) // about the files that it names
        {
          database.complete(*row);
          for(const std::string& warning : warnings_in(row->report, {NOT_COPIED}))
            add(warning);
        }
        for(const std::string& warning :
            warnings_in(row->match, {HARDLY_MATCH, OTHER_ROTATION, PARTLY_COMPARED}))
          add(warning);
      }
    }
  out << paths.size() << (paths.size() == 1 ? " shape, " : " shapes, ") << number_computed
      << " computed now\n";
  for(const auto& [outcome, number] : numbers)
    out << std::left << std::setw(14) << name_of(outcome) << number << '\n';
  out << failures << warnings;
}

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
      std::cout << line_of(row, true);
  });
  if(arguments.is_json)
    std::cout << all.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace Canonical_pose_tool
