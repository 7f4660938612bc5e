// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stances: whether shapes are understood, how near their limbs come to where a stance has them, and
// whether all postures of a shape lead to the same one. Meshes of folders and files, in classes: each
// has one shape in several postures, whose vertices correspond by index; if their numbers differ, there
// are no differences. Without files, the figure and the animal in their named poses.
//
// How to read: one line per mesh and stance, then one per class and stance, and one for all classes.
// - `found`: meshes that have a stance. `refused`: the library said why there is none, or no pose.
//   `failed`: the rest. Reasons and warnings follow the tables, with their numbers.
// - Angles are in degrees: of a limb, from shoulder to wrist or from hip to ankle, to where the stance
//   has it (`left arm` .. `right leg`; front and hind legs of animals), their means (`arms`, `legs`), the
//   largest one, and the share of limbs `within` 5 degrees. `bend` is the one at elbow or knee: 0 is
//   straight; largest one, or mean and largest one.
// - `l-r`: the mean distance of a joint of the limbs from the mirror image of its partner, at the plane
//   between left and right of the body, in percent of the root of the area of the input.
// - `strain`: median of |log(edge length in the stance / in the input)|; of a class, the median and the
//   largest one. `inverted`: cells turned inside out, in total.
// - `stance`, `pose`: mean difference over all pairs of a class (pose_difference()) of the stances and of
//   the canonical poses of the same meshes, and their ratio; for all classes, the mean of the classes.
//   pose_difference() is relative to the size of poses, and canonical poses are larger: `lengths` is the
//   ratio if differences are lengths, relative to the root of the area of the input.
// - `alike`: the share of vertices that follow the same limb, head, tail or trunk as in most postures of
//   the class, mean. Meshes below .8 follow the tables: their left and right are confused, for instance.
// - `seconds`: processor time of the stance and of the canonical pose, medians, and the median of the
//   ratios.
//
// Usage: stance_benchmark [options] [folders and files]
//   --stances A;B            of t, a, vitruvian, stand; default t, or those of figure and animal
//   --classes FILE           lines "stem class"; meshes of other stems are not used. By default, a class
//                            has the meshes of a folder whose stems are equal but for digits at their end
//   --filter REGEX           only files whose name contains a match
//   --every N                only each N-th mesh of a class
//   --vertices N             of figure and animal, default 10000
//   --csv FILE               the lines of meshes as comma-separated values
//   --geodesics, --body, --components, --rounds   as for invariance_benchmark
// Exit code: 0, or 1 if a mesh failed, or 2 for wrong usage.

#include "Argument_list.h"
#include "Stance_tables.h"
#include "Stance_trial.h"
#include "mesh_files.h"
#include "setting.h"
#include "take_options.h"

#include "collection/read_classes.h" // of the tool

#include "../../examples/Canonical_pose_3/Articulated_animal.h"
#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Tool = Canonical_pose_tool;
using namespace Canonical_pose_benchmark;
using Path = std::filesystem::path;

namespace {

std::vector<Stance> stances_of(const std::string& list)
{
  std::vector<Stance> result;
  std::istringstream words(list);
  for(std::string word; std::getline(words, word, ';');)
  {
    const auto found = std::find_if(STANCES.begin(), STANCES.end(),
                                    [&](const auto& known) { return known.first == word; });
    if(found == STANCES.end())
      throw std::invalid_argument("--stances does not know " + word);
    result.push_back(found->second);
  }
  return result;
}

void print_header_of_meshes()
{
  std::printf("%s\nangles and bends: left arm, right arm, left leg, right leg (animals: front and "
              "hind legs)\n%-22s%-11s%-8s%24s%24s%7s%8s%9s%9s%7s%6s  %s\n",
              setting().c_str(), "mesh", "stance", "outcome", "angles", "bends", "l-r", "strain",
              "inverted", "seconds", "ratio", "front", "reason or warnings");
}

void print(const Stance_trial& trial)
{
  std::printf("%-22s%-11s%-8s", trial.mesh->name.c_str(), name(trial.stance), name(trial.outcome));
  if(trial.outcome == Stance_trial::FOUND)
  {
    for(const double angle : trial.limbs.angles)
      std::printf("%6.1f", angle);
    for(const double bend : trial.limbs.bends)
      std::printf("%6.1f", bend);
    std::printf("%7.2f%8.4f%9zu%9.2f%7.2f%6s", 100 * trial.limbs.asymmetry, trial.strain,
                trial.inverted, trial.seconds, trial.seconds / trial.mesh->seconds,
                trial.is_front_certain ? "yes" : "no");
  }
  else
    std::printf("%94s", "");
  std::printf("  %s%s\n", trial.reason.c_str(),
              boost::algorithm::join(trial.warnings, "; ").c_str());
  std::fflush(stdout);
}

std::string quoted(const std::string& text)
{
  return '"' + std::regex_replace(text, std::regex("\""), "\"\"") + '"';
}

void write_csv_header(std::ostream& out)
{
  out
    << "class,mesh,stance,outcome,reason,warnings,angle_left_arm,angle_right_arm,angle_left_leg,"
       "angle_right_leg,bend_left_arm,bend_right_arm,bend_left_leg,bend_right_leg,asymmetry,strain,"
       "inverted,is_front_certain,seconds,seconds_of_pose"
    << std::endl;
}

void write_csv(std::ostream& out, const Stance_trial& trial)
{
  out << quoted(trial.mesh->class_name) << ',' << quoted(trial.mesh->name) << ','
      << name(trial.stance) << ',' << name(trial.outcome) << ',' << quoted(trial.reason) << ','
      << quoted(boost::algorithm::join(trial.warnings, "; "));
  if(trial.outcome == Stance_trial::FOUND)
  {
    for(const double angle : trial.limbs.angles)
      out << ',' << angle;
    for(const double bend : trial.limbs.bends)
      out << ',' << bend;
    out << ',' << trial.limbs.asymmetry << ',' << trial.strain << ',' << trial.inverted << ','
        << trial.is_front_certain << ',' << trial.seconds;
  }
  else
    out << std::string(13, ',');
  out << ',' << trial.mesh->seconds << std::endl;
}

class Stance_benchmark
{
public:
  Stance_benchmark(const Options& options, const std::string& csv) : m_options(options)
  {
    if(csv.empty())
      return;
    m_csv.open(csv);
    write_csv_header(m_csv);
    if(!m_csv)
      throw std::invalid_argument("cannot write " + csv);
  }

  void add(const std::string& class_name, const std::string& name, const Tool::Mesh_file& file,
           const std::vector<Stance>& stances)
  {
    const auto mesh
      = std::make_shared<const Posed_mesh_of_class>(class_name, name, file, m_options);
    for(const Stance stance : stances)
    {
      m_trials.emplace_back(mesh, stance, m_options);
      print(m_trials.back());
      if(m_csv.is_open())
        write_csv(m_csv, m_trials.back());
    }
  }

  const std::vector<Stance_trial>& trials() const { return m_trials; }

  bool has_failed() const
  {
    return std::any_of(m_trials.begin(), m_trials.end(), [](const Stance_trial& trial) {
      return trial.outcome == Stance_trial::FAILED;
    });
  }

private:
  const Options m_options;
  std::ofstream m_csv;
  std::vector<Stance_trial> m_trials;
};

template <class Shape>
void add_shape(const std::string& class_name, const std::size_t number_of_vertices,
               const std::vector<Stance>& stances, Stance_benchmark& benchmark)
{
  if(stances.empty())
    return;
  const Shape shape(number_of_vertices);
  Tool::Mesh_file mesh;
  mesh.faces = shape.triangles();
  for(const auto& pose : Shape::named_poses())
  {
    mesh.points = shape.points(pose.angles);
    benchmark.add(class_name, pose.name, mesh, stances);
  }
}

// Figure and animal, each with those of the stances that it has.
void add_shapes(const std::size_t number_of_vertices, std::vector<Stance> stances,
                Stance_benchmark& benchmark)
{
  if(stances.empty())
    for(const auto& [stance_name, stance] : STANCES)
      stances.push_back(stance);
  const auto of_animals = std::stable_partition(
    stances.begin(), stances.end(), [](const Stance stance) { return stance != Stance::STAND; });
  add_shape<Canonical_pose_examples::Articulated_figure>("figure", number_of_vertices,
                                                         {stances.begin(), of_animals}, benchmark);
  add_shape<Canonical_pose_examples::Articulated_animal>("animal", number_of_vertices,
                                                         {of_animals, stances.end()}, benchmark);
}

// The stem without digits at its end, and what separates them from the rest; otherwise the folder.
std::string class_of(const Path& file)
{
  const std::string stem = Tool::stem_of(file.string());
  const std::size_t last = stem.find_last_not_of("0123456789");
  if(last == stem.npos)
    return std::filesystem::absolute(file).parent_path().filename().string();
  const std::size_t end = stem.find_last_not_of("._- ", last);
  return stem.substr(0, end == stem.npos ? last + 1 : end + 1);
}

// The class of each file, in the order of the classes.
std::vector<std::pair<std::string, Path>> files_by_class(const std::vector<Path>& files,
                                                         const std::string& file_of_classes,
                                                         const std::size_t step)
{
  std::map<std::string, std::string> classes;
  if(!file_of_classes.empty())
    classes = Tool::read_classes(file_of_classes);
  std::map<std::string, std::vector<Path>> members;
  for(const Path& file : files)
    if(file_of_classes.empty())
      members[class_of(file)].push_back(file);
    else if(const auto found = classes.find(Tool::stem_of(file.string())); found != classes.end())
      members[found->second].push_back(file);
  std::vector<std::pair<std::string, Path>> result;
  for(const auto& [class_name, all] : members)
    for(std::size_t i = 0; i < all.size(); i += step)
      result.emplace_back(class_name, all[i]);
  if(result.empty())
    throw std::invalid_argument("there is no mesh to run");
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const Options options = take_options(arguments);
    std::vector<Stance> stances = stances_of(arguments.take_text("--stances"));
    const std::string classes = arguments.take_text("--classes");
    const std::regex filter(arguments.take_text("--filter"));
    const auto step = static_cast<std::size_t>((std::max)(1., arguments.take_number("--every", 1)));
    const auto vertices = static_cast<std::size_t>(arguments.take_number("--vertices", 10000));
    Stance_benchmark benchmark(options, arguments.take_text("--csv"));
    const std::vector<std::string> places = arguments.rest();

    bool all_done = true;
    if(places.empty())
    {
      print_header_of_meshes();
      add_shapes(vertices, stances, benchmark);
    }
    else
    {
      const auto files = files_by_class(mesh_files(places, filter), classes, step);
      if(stances.empty())
        stances = {Stance::T};
      print_header_of_meshes();
      for(const auto& [class_name, file] : files)
        try
        {
          benchmark.add(class_name, Tool::stem_of(file.string()),
                        Tool::read_mesh_file(file.string()), stances);
        }
        catch(const std::exception& e)
        {
          std::cerr << file.string() << ": " << e.what() << '\n';
          all_done = false;
        }
    }
    Stance_tables(benchmark.trials()).print();
    return all_done && !benchmark.has_failed() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << "stance_benchmark: " << e.what() << '\n';
    return 2;
  }
}
