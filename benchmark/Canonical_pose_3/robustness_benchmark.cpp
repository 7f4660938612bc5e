// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Robustness: every mesh of a folder through the one call, each in a process of its own.
//
// How to read: one line per mesh, then a summary per folder. A mesh is
// - `solved` if the registration converged, the pose is finite, the stress of the first target is at
//   most 0.30, and the pose encloses 0.7 to 1.25 times the volume of the input; it is the body's volume
//   that decides (column `volume`), that inside the repaired surface stands beside it (`surface`);
// - `refused` if the library said why it would not begin (std::invalid_argument);
// - `failed` otherwise: another exception, a crash, no memory, no time, or a pose that misses one of
//   the conditions.
// `inverted`: cells turned inside out; `strain`: median of |log(edge length in the pose / in the
// input)|; `seconds` and `MB` (peak memory) are those of the process, reading included. Numbers are
// left out of the reasons in the summary, so that equal ones meet.
//
// Usage: robustness_benchmark [options] folders and files (OFF, OBJ, PLY, STL, MEDIT)
//   --filter REGEX          only files whose name contains a match
//   --list                  print which files these are, and stop
//   --time-limit SECONDS    per mesh, default 120
//   --memory-limit MB       per mesh, default none
//   --jobs N                meshes at a time, which share the cores; default 1
//   --geodesics heat|wavefront|exact   --body auto|lattice|tetgen|mesh
//   --components auto|refuse|largest|each   --rounds N
//   --csv FILE              the table as comma-separated values
//   --pose-directory DIR    keep the poses, as DIR/<folder>/<file>
// Exit code: 0, or 1 if a mesh failed, or 2 for wrong usage.

#include "Argument_list.h"
#include "Child_process.h"
#include "enclosed_volume.h"
#include "median.h"
#include "mesh_files.h"
#include "setting.h"
#include "take_options.h"

#include "compute_pose.h" // of the tool

#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Tool = Canonical_pose_tool;
using Canonical_pose_benchmark::Argument_list;
using Canonical_pose_benchmark::Child_process;
using Path = std::filesystem::path;

namespace {

constexpr double largest_stress = 0.30, smallest_volume = 0.7, largest_volume = 1.25;

struct Arguments
{
  std::vector<Path> files;
  CP::Options options;
  Canonical_pose_benchmark::Limits limits;
  std::size_t jobs = 1;
  bool list = false;
  Path csv, pose_directory;
};

// What the child sends: bytes.
struct Measures
{
  std::size_t vertices, cells, inverted;
  int iterations;
  bool is_finite, is_converged;
  double stress, volume, surface_volume, strain;
  char body[16];
};

struct Result
{
  Path file;
  enum Outcome { SOLVED, REFUSED, FAILED } outcome = FAILED;
  std::string reason;
  bool has_pose = false;
  Measures measures = {};
  double seconds = 0, megabytes = 0;
};

const char* name(const Result::Outcome outcome)
{
  static const char* const names[] = {"solved", "refused", "failed"};
  return names[outcome];
}

Arguments parse(const int argc, char** argv)
{
  Argument_list list(argc, argv);
  Arguments result;
  result.options = take_options(list);
  result.limits.seconds = list.take_number("--time-limit", 120);
  result.limits.megabytes = static_cast<std::size_t>(list.take_number("--memory-limit", 0));
  result.jobs = static_cast<std::size_t>((std::max)(1., list.take_number("--jobs", 1)));
  result.list = list.take_flag("--list");
  result.csv = list.take_text("--csv");
  result.pose_directory = list.take_text("--pose-directory");
  if(result.jobs > 1)
    result.options.number_of_threads
      = (std::max)(1, static_cast<int>(std::thread::hardware_concurrency() / result.jobs));
  const std::regex filter(list.take_text("--filter"));
  result.files = Canonical_pose_benchmark::mesh_files(list.rest(), filter);
  if(result.files.empty())
    throw std::invalid_argument("there is no mesh to run");
  return result;
}

// The volume that the repaired surface encloses in the pose, by that in the input.
double surface_volume_ratio(const Tool::Mesh_file& input, const CP::Point_matrix& pose)
{
  if(input.is_tetrahedral)
    return std::numeric_limits<double>::quiet_NaN();
  const CP::Repaired_surface_3 surface
    = CP::repair_surface(Tool::matrix_of(Tool::points_of(input)), input.faces);
  CP::Point_matrix moved(surface.points.rows(), 3);
  for(std::size_t i = 0; i < surface.origins.size(); ++i)
    moved.row(static_cast<Eigen::Index>(i))
      = pose.row(static_cast<Eigen::Index>(surface.origins[i]));
  using Canonical_pose_benchmark::enclosed_volume;
  return enclosed_volume(moved, surface.triangles, surface.caps)
         / enclosed_volume(surface.points, surface.triangles, surface.caps);
}

// In the child.
std::string run(const Path& file, const Arguments& arguments)
{
  const Tool::Mesh_file input = Tool::read_mesh_file(file.string());
  const CP::Result result = Tool::compute_pose(input, arguments.options);
  const CP::Registration_summary& summary = result.summary;
  Measures measures = {};
  measures.vertices = input.points.size();
  measures.cells = summary.body.tetrahedra;
  measures.inverted = summary.inverted;
  measures.iterations = summary.iterations;
  measures.is_finite = result.pose.allFinite();
  measures.is_converged = summary.converged();
  measures.stress = summary.target.stress;
  measures.volume = summary.volume_ratio;
  measures.surface_volume = surface_volume_ratio(input, result.pose);
  measures.strain = summary.median_edge_strain;
  summary.body.kind.copy(measures.body, sizeof(measures.body) - 1);
  if(!arguments.pose_directory.empty())
  {
    const Path folder = std::filesystem::absolute(file).parent_path().filename();
    std::filesystem::create_directories(arguments.pose_directory / folder);
    std::ofstream out(arguments.pose_directory / folder / file.filename(), std::ios::binary);
    Tool::write_mesh(out, Tool::format_of(file.string()), Tool::with_points(input, result.pose));
    if(!out.flush())
      throw std::runtime_error("the pose cannot be written");
  }
  return std::string(reinterpret_cast<const char*>(&measures), sizeof(measures));
}

std::string with_number(const char* what, const double number)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%s %.3f", what, number);
  return text;
}

// Why the pose is none to work with; empty if it is.
std::string defect(const Measures& measures)
{
  if(!measures.is_finite)
    return "the pose is not finite";
  if(!measures.is_converged)
    return "not converged";
  if(!(measures.stress <= largest_stress))
    return with_number("stress", measures.stress);
  if(!(measures.volume >= smallest_volume && measures.volume <= largest_volume))
    return with_number("volume", measures.volume);
  return "";
}

Result result_of(const Path& file, const Child_process& child)
{
  Result result;
  result.file = file;
  result.seconds = child.seconds();
  result.megabytes = child.peak_megabytes();
  if(child.ending() == Child_process::RETURNED)
  {
    std::memcpy(&result.measures, child.output().data(), sizeof(Measures));
    result.has_pose = true;
    result.reason = defect(result.measures);
    result.outcome = result.reason.empty() ? Result::SOLVED : Result::FAILED;
  }
  else
  {
    result.reason = child.description();
    result.outcome = child.ending() == Child_process::REFUSED ? Result::REFUSED : Result::FAILED;
  }
  return result;
}

void print_header()
{
  std::printf("%s\n%-24s%-8s%9s %-8s%9s%9s%8s%8s%8s%8s%8s%9s%7s  %s\n",
              Canonical_pose_benchmark::setting().c_str(), "mesh", "outcome", "vertices", "body",
              "cells", "inverted", "stress", "volume", "surface", "strain", "iterat.", "seconds",
              "MB", "reason");
}

void print(const Result& r)
{
  std::printf("%-24s%-8s", r.file.filename().string().c_str(), name(r.outcome));
  const Measures& m = r.measures;
  if(r.has_pose)
    std::printf("%9zu %-8s%9zu%9zu%8.4f%8.3f%8.3f%8.4f%8d", m.vertices, m.body, m.cells, m.inverted,
                m.stress, m.volume, m.surface_volume, m.strain, m.iterations);
  else
    std::printf("%75s", "");
  std::printf("%9.2f%7.0f  %s\n", r.seconds, r.megabytes, r.reason.c_str());
  std::fflush(stdout);
}

std::string quoted(const std::string& text)
{
  return '"' + std::regex_replace(text, std::regex("\""), "\"\"") + '"';
}

void write_csv(std::ostream& out, const Result& r)
{
  const Measures& m = r.measures;
  out << quoted(r.file.parent_path().string()) << ',' << quoted(r.file.filename().string()) << ','
      << name(r.outcome) << ',' << quoted(r.reason) << ',' << r.seconds << ',' << r.megabytes;
  if(r.has_pose)
    out << ',' << m.vertices << ',' << m.body << ',' << m.cells << ',' << m.inverted << ','
        << m.stress << ',' << m.volume << ',' << m.surface_volume << ',' << m.strain << ','
        << m.iterations;
  else
    out << ",,,,,,,,,";
  out << std::endl;
}

// Runs all meshes and hands the results over in their order.
template <class Function>
void run_all(const Arguments& arguments, const Function& hand_over)
{
  const std::vector<Path>& files = arguments.files;
  std::list<std::pair<std::size_t, Child_process>> running;
  std::map<std::size_t, Result> waiting;
  for(std::size_t next = 0, handed_over = 0; handed_over < files.size();)
  {
    for(; running.size() < arguments.jobs && next < files.size(); ++next)
      running.emplace_back(
        std::piecewise_construct, std::forward_as_tuple(next),
        std::forward_as_tuple([&, next] { return run(files[next], arguments); }, arguments.limits));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    for(auto job = running.begin(); job != running.end();)
      if(job->second.has_ended())
      {
        waiting.emplace(job->first, result_of(files[job->first], job->second));
        job = running.erase(job);
      }
      else
        ++job;
    for(; waiting.count(handed_over) > 0; waiting.erase(handed_over++))
      hand_over(waiting.at(handed_over));
  }
}

void print_summary(const std::string& folder, const std::vector<Result>& results)
{
  std::array<std::size_t, 3> numbers = {};
  std::map<std::string, std::vector<std::string>> reasons;
  std::vector<double> seconds;
  for(const Result& r : results)
  {
    ++numbers[r.outcome];
    seconds.push_back(r.seconds);
    if(r.outcome != Result::SOLVED)
      reasons[name(r.outcome) + std::string(": ")
              + std::regex_replace(r.reason, std::regex("[0-9.]*[0-9]"), "#")]
        .push_back(r.file.filename().string());
  }
  std::printf("\n%s: %zu meshes, %zu solved, %zu refused, %zu failed; seconds: median %.2f, "
              "largest %.2f\n",
              folder.c_str(), results.size(), numbers[Result::SOLVED], numbers[Result::REFUSED],
              numbers[Result::FAILED], Canonical_pose_benchmark::median(seconds),
              *std::max_element(seconds.begin(), seconds.end()));
  for(const auto& [reason, meshes] : reasons)
    std::printf("%5zu %s (%s%s)\n", meshes.size(), reason.c_str(), meshes.front().c_str(),
                meshes.size() > 1 ? ", ..." : "");
}

bool run_and_report(const Arguments& arguments)
{
  std::ofstream csv;
  if(!arguments.csv.empty())
  {
    csv.open(arguments.csv);
    csv
      << "folder,mesh,outcome,reason,seconds,megabytes,vertices,body,cells,inverted,stress,volume,"
         "surface_volume,strain,iterations"
      << std::endl;
    if(!csv)
      throw std::invalid_argument("cannot write " + arguments.csv.string());
  }
  print_header();
  std::map<std::string, std::vector<Result>> by_folder;
  bool has_failed = false;
  run_all(arguments, [&](const Result& result) {
    print(result);
    if(csv.is_open())
      write_csv(csv, result);
    by_folder[result.file.parent_path().string()].push_back(result);
    has_failed = has_failed || result.outcome == Result::FAILED;
  });
  for(const auto& [folder, results] : by_folder)
    print_summary(folder, results);
  return !has_failed;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Arguments arguments = parse(argc, argv);
    if(!arguments.list)
      return run_and_report(arguments) ? EXIT_SUCCESS : EXIT_FAILURE;
    for(const Path& file : arguments.files)
      std::cout << file.string() << '\n';
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "robustness_benchmark: " << e.what() << '\n';
    return 2;
  }
}
