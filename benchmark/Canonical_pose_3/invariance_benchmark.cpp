// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Invariance: how much the canonical poses of one shape differ. The figure in its five named poses,
// or the given mesh files, all of the same shape.
//
// How to read: one line per mesh. `stress` is the deviation of the first target from the geodesic
// distances, `rounds` is their number, `energy` is minimized by the registration, `inverted` is the
// number of inverted cells, `strain` the median of |log(edge length in the pose / in the input)|;
// `certain` tells whether the handedness is. The last line contains mean differences over all pairs
// of meshes: root mean square distance of corresponding vertices after the best rigid motion, without
// reflection, at unit radius of gyration. The better the bends of the shape are removed, the smaller
// the number of the poses compared to that of the inputs; the number of the targets, which are those
// of the last round, is achieved by distances alone, without regard to detail. Poses that have the
// other handedness than most of them, see align_handedness(), are named after it.
//
// Usage: invariance_benchmark [options] [mesh files]
//   --vertices N             of the figure, default 10000
//   --vertex-lists FILE|DIR  corresponding vertices: the first word of each line, of one file for all
//                            meshes or of DIR/<name>.vts for each
//   --reference-directory DIR  corresponding vertices: those nearest to the vertices of the mesh of
//                            the same name in DIR, where all meshes have the same vertices
//   --geodesics heat|wavefront|exact   --body auto|lattice|tetgen|mesh
//   --components auto|refuse|largest|each   --rounds N
// Without --vertex-lists and --reference-directory, vertices correspond by index.

#include "Argument_list.h"
#include "Correspondence.h"
#include "mean_difference.h"
#include "setting.h"
#include "take_options.h"

#include "compute_pose.h" // of the tool

#include <CGAL/Canonical_pose_3/align_handedness.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Tool = Canonical_pose_tool;
using namespace Canonical_pose_benchmark;
using Canonical_pose_examples::Articulated_figure;

namespace {

CP::Point_matrix rows(const CP::Point_matrix& points, const std::vector<std::size_t>& vertices)
{
  CP::Point_matrix result(static_cast<Eigen::Index>(vertices.size()), 3);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = points.row(static_cast<Eigen::Index>(vertices[i]));
  return result;
}

class Poses
{
public:
  Poses(const CP::Options& options, const Correspondence& correspondence)
    : m_options(options), m_correspondence(correspondence)
  {}

  void add(const std::string& name, const Tool::Mesh_file& mesh)
  {
    const CP::Point_matrix points = Tool::matrix_of(Tool::points_of(mesh));
    const std::vector<std::size_t> vertices = m_correspondence.vertices(name, points);
    const CP::Result result = Tool::compute_pose(mesh, m_options);
    const CP::Registration_summary& summary = result.summary;
    m_names.push_back(name.substr(name.find_last_of('/') + 1));
    std::printf("%-20s%9zu %-8s%9.4f%8zu%12.6f%9d%10s%9zu%9.4f%9s%9.2f\n", m_names.back().c_str(),
                mesh.points.size(), summary.body.kind.c_str(), summary.target.stress,
                summary.rounds.size(), summary.energy, summary.iterations,
                summary.converged() ? "yes" : "no", summary.inverted, summary.median_edge_strain,
                summary.target.is_handedness_certain ? "yes" : "no", summary.total_seconds());
    std::fflush(stdout);
    m_inputs.push_back(rows(points, vertices));
    m_targets.push_back(rows(*result.target, vertices));
    m_results.push_back(rows(result.pose, vertices));
  }

  std::size_t size() const { return m_results.size(); }

  void print_differences() const
  {
    std::printf("mean difference of all pairs of %zu meshes: input %.4f, target %.4f, pose %.4f\n",
                m_inputs.size(), mean_difference(m_inputs), mean_difference(m_targets),
                mean_difference(m_results));
    if(!std::isfinite(mean_difference(m_results)))
      return; // points do not correspond
    const std::vector<bool> has_other_handedness = CP::align_handedness(m_results);
    for(std::size_t i = 0; i < m_names.size(); ++i)
      if(has_other_handedness[i])
        std::printf("of the other handedness than most: %s\n", m_names[i].c_str());
  }

private:
  CP::Options m_options;
  Correspondence m_correspondence;
  std::vector<std::string> m_names;
  std::vector<CP::Point_matrix> m_inputs, m_targets, m_results;
};

void add_figure(const std::size_t number_of_vertices, Poses& poses)
{
  const Articulated_figure figure(number_of_vertices);
  Tool::Mesh_file mesh;
  mesh.faces = figure.triangles();
  for(const auto& pose : Articulated_figure::named_poses())
  {
    mesh.points = figure.points(pose.angles);
    poses.add(pose.name, mesh);
  }
}

bool add_files(const std::vector<std::string>& files, Poses& poses)
{
  bool all_done = true;
  for(const std::string& file : files)
    try
    {
      poses.add(file, Tool::read_mesh_file(file));
    }
    catch(const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      all_done = false;
    }
  return all_done;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const CP::Options options = take_options(arguments);
    const auto vertices = static_cast<std::size_t>(arguments.take_number("--vertices", 10000));
    const std::string vertex_lists = arguments.take_text("--vertex-lists");
    const std::string references = arguments.take_text("--reference-directory");
    const std::vector<std::string> files = arguments.rest();

    std::printf("%s\n%-20s%9s %-8s%9s%8s%12s%9s%10s%9s%9s%9s%9s\n", setting().c_str(), "mesh",
                "vertices", "body", "stress", "rounds", "energy", "iterat.", "converged",
                "inverted", "strain", "certain", "seconds");
    Poses poses(options, Correspondence(vertex_lists, references));
    bool all_done = true;
    if(files.empty())
      add_figure(vertices, poses);
    else
      all_done = add_files(files, poses);
    if(poses.size() > 1)
      poses.print_differences();
    return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << "invariance_benchmark: " << e.what() << '\n';
    return 2;
  }
}
