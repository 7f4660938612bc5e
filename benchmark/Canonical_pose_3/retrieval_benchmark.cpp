// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Retrieval: how well shapes of the same class find each other, by descriptors of the inputs, of
// landmark-MDS targets and the poses registered to them (the experiment of Section 8.2 of the paper),
// and of the targets and poses after rounds.
//
// How to read: one line per descriptor and shape with the measures of Retrieval_evaluation.h, and the
// seconds per shape for the descriptor alone. `fused` adds the distances of all descriptors, with
// the weights of the tool, of the poses where they depend on the pose.
//
// Usage: retrieval_benchmark [options] CLASSES FILE...
//   CLASSES          lines "stem class"; files of other stems are not used
//   --curves FILE    writes precision-recall curves (CSV)
//   --per-class      a line for each class, too

#include "Argument_list.h"
#include "formats/Cgal_types.h" // of the tool
#include "formats/Mesh_file.h"
#include "compute_pose.h"
#include "descriptors.h"
#include "collection/read_classes.h"
#include "setting.h"

#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Retrieval_evaluation.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace Canonical_pose_benchmark;
namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_tool::Descriptor;

namespace {

const std::array<std::string, 5> EMBEDDINGS
  = {"input", "LMDS target", "pose without rounds", "target", "pose"};

std::array<CP::Point_matrix, 5> embeddings(const Canonical_pose_tool::Mesh_file& mesh)
{
  CP::Options options;
  options.number_of_rounds = 0;
  const CP::Result first = Canonical_pose_tool::compute_pose(mesh, options);
  const CP::Result last = Canonical_pose_tool::compute_pose(mesh, CP::Options());
  return {Canonical_pose_tool::matrix_of(Canonical_pose_tool::points_of(mesh)), *first.target,
          first.pose, *last.target, last.pose};
}

// A descriptor of an embedding, and its values of all shapes.
struct Trial
{
  Descriptor descriptor;
  std::size_t embedding;
  std::vector<Eigen::VectorXd> values;
  double seconds = 0;

  std::string name() const { return descriptor.name + ", " + EMBEDDINGS[embedding]; }

  Eigen::MatrixXd distances() const
  {
    const auto n = static_cast<Eigen::Index>(values.size());
    Eigen::MatrixXd all(descriptor.size, n), result(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
      all.col(i) = values[static_cast<std::size_t>(i)];
    for(Eigen::Index i = 0; i < n; ++i)
      result.col(i) = descriptor.distances(all.col(i), all);
    return result;
  }
};

class Retrieval_benchmark
{
public:
  Retrieval_benchmark()
  {
    for(const Descriptor& descriptor : Canonical_pose_tool::descriptors({}))
      for(std::size_t e = 0; e < (descriptor.needs_pose ? EMBEDDINGS.size() : 1); ++e)
        m_trials.push_back({descriptor, e, {}});
  }

  void add(const std::string& file, const std::string& name_of_class)
  {
    const Canonical_pose_tool::Mesh_file mesh = Canonical_pose_tool::read_mesh_file(file);
    const std::array<CP::Point_matrix, 5> points = embeddings(mesh);
    std::vector<Eigen::VectorXd> values;
    for(Trial& trial : m_trials)
    {
      const auto start = std::chrono::steady_clock::now();
      values.push_back(trial.descriptor.values(points[trial.embedding], mesh.faces));
      trial.seconds
        += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    for(std::size_t i = 0; i < m_trials.size(); ++i)
      m_trials[i].values.push_back(std::move(values[i]));
    const auto found = std::find(m_names.begin(), m_names.end(), name_of_class);
    m_classes.push_back(static_cast<std::size_t>(found - m_names.begin()));
    if(found == m_names.end())
      m_names.push_back(name_of_class);
  }

  void print(const bool per_class, std::ostream& curves) const
  {
    std::printf("%zu shapes, %zu classes\n", m_classes.size(), m_names.size());
    std::printf("%-44s%-12s%8s%8s%8s%8s%8s%8s%9s\n", "descriptor", "class", "NN", "FT", "ST", "E",
                "DCG", "mAP", "seconds");
    curves << "descriptor,recall,precision\n";
    std::vector<Eigen::MatrixXd> fused;
    std::vector<double> weights;
    for(const Trial& trial : m_trials)
    {
      const Eigen::MatrixXd distances = trial.distances();
      print_rows(trial.name(), distances, trial.seconds / static_cast<double>(m_classes.size()),
                 per_class, curves);
      if(!trial.descriptor.needs_pose || trial.embedding + 1 == EMBEDDINGS.size())
      {
        fused.push_back(distances);
        weights.push_back(trial.descriptor.weight);
      }
    }
    const Eigen::MatrixXd sum = CP::fused_distances(fused, weights);
    print_rows("fused", sum, 0, per_class, curves);
    print_rows("fused, manifold ranking", CP::manifold_ranking(sum), 0, per_class, curves);
  }

private:
  void print_rows(const std::string& name, const Eigen::MatrixXd& distances, const double seconds,
                  const bool per_class, std::ostream& curves) const
  {
    const CP::Retrieval_evaluation evaluation(distances, m_classes);
    print_row(name, "all", evaluation.mean(), seconds);
    for(std::size_t c = 0; per_class && c < m_names.size(); ++c)
      if(std::count(m_classes.begin(), m_classes.end(), c) > 1)
        print_row(name, m_names[c], evaluation.mean_of_class(c), seconds);
    const std::vector<double>& precision = evaluation.precision();
    for(std::size_t i = 0; i < precision.size(); ++i)
      curves << '"' << name << "\","
             << static_cast<double>(i + 1) / static_cast<double>(precision.size()) << ','
             << precision[i] << '\n';
  }

  static void print_row(const std::string& name, const std::string& name_of_class,
                        const CP::Retrieval_measures& m, const double seconds)
  {
    std::printf("%-44s%-12s%8.4f%8.4f%8.4f%8.4f%8.4f%8.4f%9.3f\n", name.c_str(),
                name_of_class.c_str(), m.nearest_neighbor, m.first_tier, m.second_tier, m.e_measure,
                m.discounted_cumulative_gain, m.average_precision, seconds);
  }

  std::vector<Trial> m_trials;
  std::vector<std::size_t> m_classes; // of the shapes
  std::vector<std::string> m_names;   // of the classes
};

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const std::string curves_file = arguments.take_text("--curves");
    const bool per_class = arguments.take_flag("--per-class");
    if(arguments.rest().size() < 2)
      throw std::invalid_argument("the classes and files of shapes are needed");
    const std::map<std::string, std::string> classes
      = Canonical_pose_tool::read_classes(arguments.rest().front());
    std::ofstream curves; // discards what it is given if it is not open
    if(!curves_file.empty())
    {
      curves.open(curves_file);
      if(!curves)
        throw std::invalid_argument("cannot write " + curves_file);
    }
    std::printf("%s\n", setting().c_str());
    Retrieval_benchmark benchmark;
    bool all_done = true;
    for(std::size_t i = 1; i < arguments.rest().size(); ++i)
      try
      {
        const std::string& file = arguments.rest()[i];
        const auto found = classes.find(std::filesystem::path(file).stem().string());
        if(found != classes.end())
          benchmark.add(file, found->second);
      }
      catch(const std::exception& e)
      {
        std::cerr << arguments.rest()[i] << ": " << e.what() << '\n';
        all_done = false;
      }
    benchmark.print(per_class, curves);
    return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << "retrieval_benchmark: " << e.what() << '\n';
    return 2;
  }
}
