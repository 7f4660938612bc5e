// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMMAND_LINE_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMMAND_LINE_H

#include <CGAL/Canonical_pose_3/Match_options.h>
#include <CGAL/Canonical_pose_3/Options.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

struct Command;

// The command line asks for what cannot be, whatever the files hold.
struct Usage_error : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

// The parsed command line.
struct Arguments
{
  const Command* command = nullptr;
  std::string input;
  std::string output; // POSE, DISTANCES, or OUT of SEGMENT and DESCRIBE, PAGE; mean of COMPARE
  std::string target; // this and the next seven: empty if not requested
  std::string scene;
  std::string report;
  std::string matching_weights; // this and the next: files of numbers
  std::string stiffness;
  std::string stance_file;     // empty for a stance with a name
  std::string given_target;    // mesh file
  std::string given_distances; // file of numbers
  std::string geodesics = "heat";
  std::vector<std::size_t> sources;
  std::vector<std::string> poses; // this and the next: of COMPARE
  bool has_pairs = false;
  std::string pose;              // of SEGMENT, DESCRIBE and MATCH
  std::string other, other_pose; // this and the next four: of MATCH
  std::string map, transfer;     // empty if not requested
  bool is_mirrored = false;
  CGAL::Canonical_pose_3::Match_options match;
  std::vector<std::string> descriptors; // names, of DESCRIBE
  std::string method = "consensus";     // this and the next: of SEGMENT
  std::size_t number_of_parts = 0;      // 0: automatic
  std::vector<std::string> inputs;      // of PAGE and COLLECTION
  // Of COLLECTION and its kin.
  std::string database;
  std::string pose_folder;
  std::string match_template, match_folder; // empty if not requested
  std::vector<std::string> pose_words; // the options of `pose` that were given, as words
  std::string pose_options;            // the same as a text
  bool is_segmented = false;
  bool has_no_descriptor = false;
  bool is_listed = false, are_failures_listed = false, is_json = false, is_merged = false;
  std::size_t shard = 1, number_of_shards = 1;
  std::size_t number_of_workers = 0;
  double time_limit = 3600, memory_limit = 0; // seconds, megabytes; 0: none
  std::size_t number_of_answers = 10;
  std::string classes; // file
  std::string rerank;
  std::string csv, plot;
  CGAL::Canonical_pose_3::Options options;
  bool quiet = false;
  bool is_watched = false; // on a terminal
  // Tells what is being done if the run is watched; an empty text before other output.
  std::function<void(const std::string&)> say = [](const std::string&) {};
  bool is_strict = false; // of CHECK
};

// Exit codes, beside those of success and failure; the second one is of `check --strict`.
inline constexpr int WRONG_USAGE = 2, DEFECTS_FOUND = 3;

// Reads the command line. Returns the exit code if there is nothing left to do: 0 after --help, 2
// for wrong usage.
std::optional<int> parse_command_line(int argc, char* argv[], Arguments& arguments);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMMAND_LINE_H
