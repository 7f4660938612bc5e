// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command compare.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/mean_pose.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Without and with reflection.
using Differences = Eigen::Array2d;

struct Pair
{
  std::size_t first, second;
  Differences differences;
};

// Throws std::invalid_argument, with the names of the files, if two of them cannot be compared.
std::vector<Pair> differences_of_pairs(const std::vector<std::string>& names,
                                       const std::vector<Point_matrix>& poses)
{
  std::vector<Pair> result;
  for(std::size_t i = 0; i < poses.size(); ++i)
    for(std::size_t j = i + 1; j < poses.size(); ++j)
      try
      {
        using CGAL::Canonical_pose_3::pose_difference;
        result.push_back({i,
                          j,
                          {pose_difference(poses[i], poses[j], false),
                           pose_difference(poses[i], poses[j], true)}});
      }
      catch(const std::invalid_argument& error)
      {
        throw std::invalid_argument(names[i] + ", " + names[j] + ": " + error.what());
      }
  return result;
}

// The mean of the pairs for which `is_one` holds.
template <class Predicate>
Differences mean(const std::vector<Pair>& pairs, const Predicate& is_one)
{
  Differences sum = Differences::Zero();
  double number = 0;
  for(const Pair& pair : pairs)
    if(is_one(pair))
    {
      sum += pair.differences;
      ++number;
    }
  return sum / number;
}

Differences mean(const std::vector<Pair>& pairs)
{
  return mean(pairs, [](const Pair&) { return true; });
}

void write_line(std::ostream& out, const Differences& differences, const std::string& text)
{
  out << differences[0] << "  " << differences[1] << "   " << text << '\n';
}

// Of each pair or, of many poses, the mean of each with the others; then the mean of all pairs.
void write_differences(std::ostream& out, const std::vector<std::string>& names,
                       const std::vector<Pair>& pairs, const bool has_pairs)
{
  std::ostringstream text;
  text.precision(6);
  text << std::fixed << "proper    reflected\n";
  if(has_pairs || names.size() == 2)
    for(const Pair& pair : pairs)
      write_line(text, pair.differences, names[pair.first] + ' ' + names[pair.second]);
  else
    for(std::size_t i = 0; i < names.size(); ++i)
      write_line(text, mean(pairs, [&](const Pair& p) { return p.first == i || p.second == i; }),
                 names[i]);
  write_line(text, mean(pairs),
             "mean of " + std::to_string(pairs.size()) + (pairs.size() == 1 ? " pair" : " pairs"));
  out << text.str();
}

nlohmann::ordered_json json_of(const Differences& differences)
{
  return {{"proper", differences[0]}, {"reflected", differences[1]}};
}

void write_pairs(std::ostream& out, const std::vector<std::string>& names,
                 const std::vector<Pair>& pairs)
{
  nlohmann::ordered_json report
    = {{"mean", json_of(mean(pairs))}, {"pairs", nlohmann::ordered_json::array()}};
  for(const Pair& pair : pairs)
  {
    nlohmann::ordered_json of_pair = {{"poses", {names[pair.first], names[pair.second]}}};
    of_pair.update(json_of(pair.differences));
    report["pairs"].push_back(of_pair);
  }
  out << report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void add_compare_options(Command_options& o)
{
  o.app.add_option("POSE", o.arguments.poses, "two or more meshes with corresponding vertices")
    ->required()
    ->expected(2, -1);
  o.app.add_flag("--pairs", o.arguments.has_pairs, "print each pair, also of more than two poses");
  add_path(o, "--mean", o.arguments.output,
           "also write the mean of the poses, moved onto each other, with the faces of the first");
  add_report(o);
  add_quiet(o);
}

// The first mesh, of which all but the positions is written with the mean.
Mesh_file read_first(const Arguments& arguments)
{
  const std::string &path = arguments.poses.front(), &mean = arguments.output;
  arguments.say("reading " + path);
  if(mean.empty())
    return read_other_mesh_file(path);
  const Format format = format_of_output(mean);
  Mesh_file mesh = read_other_mesh_file(path, Source::KEPT);
  if(mesh.is_tetrahedral != (format == Format::MEDIT || format == Format::VTU))
    throw std::invalid_argument(
      "the mean in '" + mean + "' must be a "
      + (mesh.is_tetrahedral ? "tetrahedral mesh (.mesh, .vtu)" : "surface") + ", as '" + path
      + "' is");
  load_appearance_for(mesh, format);
  check_format_holds(format, mesh);
  return mesh;
}

int run_compare(Arguments& arguments)
{
  const std::string& mean = arguments.output;
  if(mean == "-")
    arguments.output += extension_of_format(written_format(format_of(arguments.poses.front())));
  const std::vector<std::string> outputs = {mean, arguments.report};
  Output_files files(outputs, arguments.poses);
  const Mesh_file first = read_first(arguments);
  std::vector<Point_matrix> poses = {matrix_of(points_of(first))};
  for(std::size_t i = 1; i < arguments.poses.size(); ++i)
  {
    arguments.say("reading " + arguments.poses[i]);
    poses.push_back(matrix_of(points_of(read_other_mesh_file(arguments.poses[i]))));
  }
  arguments.say("comparing the poses");
  const std::vector<Pair> pairs = differences_of_pairs(arguments.poses, poses);
  std::vector<std::string> warnings;
  if(!mean.empty())
    add_losses_of_file(warnings, "the mean", first, mean);
  files.write_with_files(mean, [&](std::ostream& out, Companion_files* const beside) {
    write_pose(out, format_of(mean), first, CGAL::Canonical_pose_3::mean_pose(std::move(poses)),
               beside);
  });
  files.write(arguments.report,
              [&](std::ostream& out) { write_pairs(out, arguments.poses, pairs); });
  files.commit();
  arguments.say("");
  if(arguments.quiet)
    return EXIT_SUCCESS;
  std::ostream& out = messages_beside(outputs);
  write_differences(out, arguments.poses, pairs, arguments.has_pairs);
  for(const std::string& warning : warnings)
    out << "warning: " << warning << '\n';
  return EXIT_SUCCESS;
}

} // namespace

const Command COMPARE_COMMAND
  = {"compare",
     "measures how much poses differ, independent of position and scale",
     {"compare sitting.off standing.off", "compare poses/*.off",
      "compare matched/*.off --mean mean.off"},
     add_compare_options,
     run_compare};

} // namespace Canonical_pose_tool
