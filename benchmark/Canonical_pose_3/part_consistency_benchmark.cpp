// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Consistency: whether a shape has the same parts in all poses.
//
// How to read: one line per method: the share of the area of faces whose part is the same in two
// meshes, after the best matching of the parts, as mean over all pairs of meshes and as least one; and
// the mean number of parts, which is not always the requested one.
//
// Usage: part_consistency_benchmark [options] mesh files
//   mesh files           of the same shape, with the same faces
//   --parts K            number of parts, default 8
//   --methods A;B        their names; default: all

#include "Argument_list.h"
#include "Segmentation_errors.h"
#include "Segmentation_methods.h"
#include "setting.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/maximum_weighted_matching.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace Canonical_pose_benchmark;

namespace {

// The share of the weights of the pairs of parts in the best matching. Boost needs integers: with
// rounding errors, its iteration may not end.
double agreement(const Contingency_table& areas)
{
  using Graph
    = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, long long>>;
  constexpr double scale = 1e9;
  const Eigen::MatrixXd& table = areas.table();
  const auto rows = static_cast<std::size_t>(table.rows());
  Graph graph(rows + static_cast<std::size_t>(table.cols()));
  for(Eigen::Index i = 0; i < table.rows(); ++i)
    for(Eigen::Index j = 0; j < table.cols(); ++j)
      if(table(i, j) > 0)
        boost::add_edge(static_cast<std::size_t>(i), rows + static_cast<std::size_t>(j),
                        std::llround(scale * table(i, j) / areas.total()), graph);
  std::vector<boost::graph_traits<Graph>::vertex_descriptor> mates(boost::num_vertices(graph));
  boost::maximum_weighted_matching(graph, mates.data());
  double sum = 0;
  for(std::size_t i = 0; i < rows; ++i)
    if(mates[i] != boost::graph_traits<Graph>::null_vertex())
      sum += table(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(mates[i] - rows));
  return sum / areas.total();
}

void run(const Segmentation_method& method, const std::vector<Posed_mesh>& shapes,
         const std::size_t number_of_parts)
{
  std::vector<Parts> parts;
  for(const Posed_mesh& shape : shapes)
    parts.push_back(method.segmentation(shape, number_of_parts));
  const Eigen::VectorXd areas = Segmentation_comparison(shapes.front().mesh).areas();
  double sum = 0, least = 1, total_number_of_parts = 0;
  std::size_t number_of_pairs = 0;
  for(const Parts& own : parts)
    total_number_of_parts += static_cast<double>(*std::max_element(own.begin(), own.end()) + 1);
  for(std::size_t i = 0; i < parts.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
    {
      const double share = agreement(Contingency_table(parts[i], parts[j], areas));
      sum += share;
      least = (std::min)(least, share);
      ++number_of_pairs;
    }
  std::printf("%-24s%8.3f%8.3f%8.1f\n", method.name.c_str(),
              sum / static_cast<double>(number_of_pairs), least,
              total_number_of_parts / static_cast<double>(parts.size()));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto number_of_parts = static_cast<std::size_t>(arguments.take_number("--parts", 8));
    const auto methods = chosen_methods(arguments.take_text("--methods"), number_of_parts > 0);
    const bool needs_pose
      = std::any_of(methods.begin(), methods.end(),
                    [](const Segmentation_method& method) { return method.needs_pose; });
    std::vector<Posed_mesh> shapes;
    for(const std::string& file : arguments.rest())
    {
      shapes.emplace_back(Canonical_pose_tool::read_mesh_file(file), needs_pose);
      if(shapes.back().mesh.faces.size() != shapes.front().mesh.faces.size())
        throw std::invalid_argument(file + " has other faces");
    }
    if(shapes.size() < 2)
      throw std::invalid_argument("at least two meshes are needed");
    std::printf("%s\n%-24s%8s%8s%8s\n", setting().c_str(), "method", "mean", "least", "parts");
    std::fflush(stdout);
    bool all_done = true;
    for(const Segmentation_method& method : methods)
      try
      {
        run(method, shapes, number_of_parts);
      }
      catch(const std::exception& e)
      {
        std::cerr << method.name << ": " << e.what() << '\n';
        all_done = false;
      }
    return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << "part_consistency_benchmark: " << e.what() << '\n';
    return 2;
  }
}
