// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Quality of the poses: the figure in its five named poses, or the mesh files given.
//
// How to read: one line per mesh. `stress` tells how far the target is from the geodesic distances,
// `energy` what the registration minimises, `inverted` the cells turned inside out, `strain` the
// median of |log(edge length in the pose / in the input)|. The last line holds mean differences
// over all pairs of meshes with corresponding vertices: root mean square distance after the best
// rigid motion, at unit radius of gyration. The more a pose forgets how the shape was bent, the
// smaller its number against that of the input; the target's is what distances alone give, without
// regard to detail. Files correspond if they have the same number of vertices, in the same order.
// Usage: quality_benchmark [--vertices 10000] [mesh files]

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"
#include "pose_difference.h"
#include "setting.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_benchmark::mean_pose_difference;
using Canonical_pose_examples::Articulated_figure;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

struct Poses
{
  std::vector<CP::Point_matrix> inputs, targets, results;

  void add(const std::string& name, const Mesh& mesh)
  {
    CP::Intermediate_results intermediate;
    CP::Options options;
    options.intermediate_results = &intermediate;
    Mesh pose = mesh;
    const CP::Registration_summary summary = CGAL::canonical_pose_3(mesh, pose.points(), options);
    std::printf("%-20s%9zu%9.4f%12.6f%9d%10s%9zu%9.4f%9.2f\n",
                name.substr(name.find_last_of('/') + 1).c_str(),
                std::size_t(mesh.number_of_vertices()), summary.target.stress, summary.energy,
                summary.iterations, summary.converged() ? "yes" : "no", summary.inverted,
                summary.median_edge_strain, summary.total_seconds());
    if(!summary.is_usable())
      return;
    inputs.push_back(CP::point_matrix(mesh));
    targets.push_back(*intermediate.target);
    results.push_back(CP::point_matrix(pose));
  }
};

Mesh read(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read it");
  return mesh;
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t vertices = 10000;
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.size() > 1 && files[0] == "--vertices")
  {
    vertices = std::stoul(files[1]);
    files.erase(files.begin(), files.begin() + 2);
  }
  std::printf("%s\n%-20s%9s%9s%12s%9s%10s%9s%9s%9s\n", Canonical_pose_benchmark::setting().c_str(),
              "mesh", "vertices", "stress", "energy", "iterat.", "converged", "inverted", "strain",
              "seconds");
  Poses poses;
  if(files.empty())
  {
    const Articulated_figure figure(vertices);
    for(const auto& pose : Articulated_figure::named_poses())
      poses.add(pose.name, figure.make_mesh<Mesh>(pose.angles));
  }
  bool all_done = true;
  for(const std::string& file : files)
    try
    {
      poses.add(file, read(file));
    }
    catch(const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      all_done = false;
    }
  std::printf("mean difference of all pairs: input %.4f, target %.4f, pose %.4f\n",
              mean_pose_difference(poses.inputs), mean_pose_difference(poses.targets),
              mean_pose_difference(poses.results));
  return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
}
