// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Segmentation: how much computed parts differ from those of people, by the protocol of X. Chen et al.,
// "A benchmark for 3D mesh segmentation", 2009. Its meshes and segmentations are not included.
//
// How to read: one line per class and method, then the means over all meshes: errors of the
// segmentations by people, averaged over the people (see Segmentation_errors.h), the number of parts,
// and seconds without those for the pose. `people` are the errors of one person by those of the
// others. The last column is the difference of the first error to that of the first method, with its
// standard error over the meshes.
//
// Usage: segmentation_benchmark [options] DIRECTORY
//   DIRECTORY                that of the benchmark, with data/ and util/
//   --models odd|even|all    numbers of the meshes
//   --parts model|auto       the number of parts: that which the benchmark has for each mesh, or
//                            determined by the method
//   --methods A;B            their names; default: all that are possible

#include "Argument_list.h"
#include "Segmentation_errors.h"
#include "Segmentation_methods.h"
#include "setting.h"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace Canonical_pose_benchmark;
using Path = std::filesystem::path;

namespace {

struct Trial
{
  Segmentation_errors errors;
  double number_of_parts = 0, seconds = 0;
};

// Of one method, by the number of the mesh.
using Trials = std::map<int, Trial>;

std::vector<std::size_t> read_indices(const Path& file)
{
  std::ifstream in(file);
  if(!in)
    throw std::invalid_argument("cannot read " + file.string());
  std::vector<std::size_t> result;
  for(std::size_t value; in >> value;)
    result.push_back(value);
  return result;
}

Parts numbered_from_zero(const std::vector<std::size_t>& labels)
{
  std::map<std::size_t, std::size_t> numbers;
  Parts result;
  for(const std::size_t label : labels)
    result.push_back(numbers.emplace(label, numbers.size()).first->second);
  return result;
}

// Means, of cut discrepancies over those that are defined.
Segmentation_errors mean(const std::vector<Segmentation_errors>& all)
{
  Segmentation_errors result;
  std::size_t number_of_cuts = 0;
  for(const Segmentation_errors& errors : all)
  {
    const double n = static_cast<double>(all.size());
    result.rand += errors.rand / n;
    result.hamming += errors.hamming / n;
    result.global += errors.global / n;
    result.local += errors.local / n;
    if(std::isfinite(errors.cut))
    {
      result.cut += errors.cut;
      ++number_of_cuts;
    }
  }
  if(number_of_cuts > 0)
    result.cut /= static_cast<double>(number_of_cuts);
  return result;
}

class Segmentation_benchmark
{
public:
  Segmentation_benchmark(Path directory, std::vector<Segmentation_method> methods,
                         const bool is_number_given)
    : m_directory(std::move(directory)), m_methods(std::move(methods)),
      m_is_number_given(is_number_given),
      m_numbers(read_indices(m_directory / "util/parameters/nSeg-ByModel.txt"))
  {
    for(const Segmentation_method& method : m_methods)
      m_needs_pose = m_needs_pose || method.needs_pose;
  }

  void run(const int id)
  {
    const std::string name = std::to_string(id);
    const Posed_mesh shape(
      Canonical_pose_tool::read_mesh_file((m_directory / "data/off" / (name + ".off")).string()),
      m_needs_pose);
    const Segmentation_comparison comparison(shape.mesh);
    std::vector<Segmentation_comparison::Segmentation> people;
    for(const auto& file :
        std::filesystem::directory_iterator(m_directory / "data/seg/Benchmark" / name))
      people.push_back(comparison.segmentation(numbered_from_zero(read_indices(file.path()))));

    std::vector<Segmentation_errors> among_people;
    for(std::size_t i = 0; i < people.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        among_people.push_back(comparison.errors(people[i], people[j]));
    m_trials["people"][id] = {mean(among_people), 0, 0};

    const std::size_t k = m_is_number_given ? m_numbers.at(static_cast<std::size_t>(id - 1)) : 0;
    for(const Segmentation_method& method : m_methods)
    {
      const auto start = std::chrono::steady_clock::now();
      Parts parts = method.segmentation(shape, k);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      const double number = static_cast<double>(*std::max_element(parts.begin(), parts.end()) + 1);
      const auto segmentation = comparison.segmentation(std::move(parts));
      std::vector<Segmentation_errors> errors;
      for(const auto& other : people)
        errors.push_back(comparison.errors(segmentation, other));
      m_trials[method.name][id] = {mean(errors), number, seconds.count()};
    }
  }

  void print() const
  {
    std::printf("%-12s%-24s%7s%8s%8s%8s%8s%8s%7s%9s\n", "class", "method", "meshes", "1-Rand",
                "cut", "Hamming", "global", "local", "parts", "seconds");
    for(std::size_t c = 0; c < CLASSES.size(); ++c)
      print_rows(CLASSES[c], [c](const int id) { return std::size_t(id - 1) / 20 == c; });
    print_rows("all", [](int) { return true; });
  }

private:
  // The class of a mesh is the quotient of its number by 20.
  static inline const std::vector<std::string> CLASSES
    = {"human",     "cup",   "glasses", "airplane", "ant",  "chair",  "octopus",
       "table",     "teddy", "hand",    "plier",    "fish", "bird",   "",
       "armadillo", "bust",  "mech",    "bearing",  "vase", "fourleg"};

  template <class Predicate>
  void print_rows(const std::string& name, const Predicate& is_included) const
  {
    print_row(name, "people", is_included);
    for(const Segmentation_method& method : m_methods)
      print_row(name, method.name, is_included);
  }

  template <class Predicate>
  void print_row(const std::string& name, const std::string& method,
                 const Predicate& is_included) const
  {
    std::vector<Segmentation_errors> errors;
    std::vector<double> differences;
    double number_of_parts = 0, seconds = 0;
    for(const auto& [id, trial] : m_trials.at(method))
      if(is_included(id))
      {
        errors.push_back(trial.errors);
        number_of_parts += trial.number_of_parts;
        seconds += trial.seconds;
        differences.push_back(trial.errors.rand
                              - m_trials.at(m_methods.front().name).at(id).errors.rand);
      }
    if(errors.empty())
      return;
    const double n = static_cast<double>(errors.size());
    const Segmentation_errors e = mean(errors);
    std::printf("%-12s%-24s%7.0f%8.4f%8.4f%8.4f%8.4f%8.4f%7.1f%9.2f", name.c_str(), method.c_str(),
                n, e.rand, e.cut, e.hamming, e.global, e.local, number_of_parts / n, seconds / n);
    if(method != m_methods.front().name && differences.size() > 1)
    {
      const Eigen::Map<const Eigen::ArrayXd> d(differences.data(),
                                               static_cast<Eigen::Index>(differences.size()));
      std::printf("  %+.4f +- %.4f", d.mean(),
                  std::sqrt((d - d.mean()).square().sum() / (n * (n - 1))));
    }
    std::printf("\n");
  }

  Path m_directory;
  std::vector<Segmentation_method> m_methods;
  bool m_is_number_given, m_needs_pose = false;
  std::vector<std::size_t> m_numbers; // of parts
  std::map<std::string, Trials> m_trials;
};

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const std::size_t models = arguments.take_choice("--models", {"odd", "even", "all"});
    const bool is_number_given = arguments.take_choice("--parts", {"model", "auto"}) == 0;
    const auto methods = chosen_methods(arguments.take_text("--methods"), is_number_given);
    if(arguments.rest().size() != 1)
      throw std::invalid_argument("the directory of the benchmark is needed");
    Segmentation_benchmark benchmark(arguments.rest().front(), methods, is_number_given);
    std::printf("%s\n", setting().c_str());
    bool all_done = true;
    for(int id = models == 1 ? 2 : 1; id <= 400; id += models == 2 ? 1 : 2)
      if(id <= 260 || id > 280) // there is no class of these
        try
        {
          benchmark.run(id);
        }
        catch(const std::exception& e)
        {
          std::cerr << id << ": " << e.what() << '\n';
          all_done = false;
        }
    benchmark.print();
    return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << "segmentation_benchmark: " << e.what() << '\n';
    return 2;
  }
}
