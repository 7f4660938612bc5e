// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Energies: why details are preserved by an as-rigid-as-possible energy, and by that of a body.
// Reproduces the two comparisons of Figure 4 of the paper, on the sitting articulated figure or the
// given mesh files.
//
// How to read: one line in Markdown per pose. All are pulled to the same target, the first one of the
// package with default options, with the same detail length, and inverted cells are not untangled.
// - `strain`: median of |log(edge length in the pose / in the input)|;
// - `distance`: root mean square distance from the target, by L;
// - `volume`: that within the surface by that of the input;
// - `intersections`: pairs of faces (an input may have some itself).
// With --prefix P, poses are written to files with names P followed by figure_body.off and so on;
// scripts/render draws them.
// Usage: energies_benchmark [--vertices 10000] [--detail-length 0.1] [--prefix P] [mesh files]

#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include "Argument_list.h"
#include "Surface_arap.h"
#include "dirichlet_pose.h"
#include "enclosed_volume.h"
#include "prepare.h"

#include "formats/Cgal_types.h" // of the tool

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <Eigen/Dense>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Tool = Canonical_pose_tool;
using namespace Canonical_pose_benchmark;
using Canonical_pose_examples::Articulated_figure;

namespace {

double volume(const Point_matrix& points, const Body_problem& problem)
{
  return enclosed_volume(points, problem.triangles, problem.caps);
}

void write_off(const std::string& path, const Point_matrix& points, const Triangles& triangles)
{
  Tool::Mesh_file mesh;
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    mesh.points.push_back({points(v, 0), points(v, 1), points(v, 2)});
  mesh.faces = triangles;
  std::ofstream out(path);
  Tool::write_mesh(out, Tool::Format::OFF, mesh);
  if(!out.flush())
    throw std::runtime_error("cannot write " + path);
}

// One mesh.
class Comparison
{
public:
  Comparison(const std::string& name, const Body_problem& problem, const double detail_length,
             const std::string& prefix)
    : m_name(name), m_problem(problem), m_prefix(prefix),
      m_shares(CP::vertex_area_shares(problem.points, problem.triangles))
  {
    const double length_scale = problem.length_scale();
    const CP::Lattice_body_3 body(problem.points, problem.triangles, problem.distances, 0,
                                  problem.caps);
    CP::Registration_options options;
    options.detail_length = detail_length;
    options.injective = false;
    CP::Tetrahedral_arap_registrar_3<CP::Lattice_body_3> registrar(body, m_shares, length_scale,
                                                                   options);
    registrar.set_target(problem.target);
    Point_matrix body_pose;
    if(!registrar.register_to_target(body_pose).is_usable())
      throw std::runtime_error("the registration met numbers that are not finite");

    add("input", "input", problem.points);
    add("target", "target", problem.target);
    add("body", "body, as rigid as possible", registrar.surface_points(body_pose));
    add("dirichlet", "body, Dirichlet",
        dirichlet_pose(body, m_shares, problem.target, length_scale, detail_length));
    add("surface", "surface, as rigid as possible",
        Surface_arap(problem.points, problem.triangles, m_shares, length_scale, detail_length)
          .run(problem.target));
  }

private:
  // `key`: for the name of the file.
  void add(const std::string& key, const std::string& what, const Point_matrix& pose) const
  {
    const auto intersections = CP::diagnose(pose, m_problem.triangles).self_intersections;
    std::printf("| %s | %s | %.3f | %.4f | %.2f | %s |\n", m_name.c_str(), what.c_str(),
                CP::median_edge_strain(m_problem.points, pose, m_problem.triangles),
                std::sqrt((pose - m_problem.target).rowwise().squaredNorm().dot(m_shares))
                  / m_problem.length_scale(),
                volume(pose, m_problem) / volume(m_problem.points, m_problem),
                intersections ? std::to_string(*intersections).c_str() : "not examined");
    std::fflush(stdout);
    if(!m_prefix.empty())
      write_off(m_prefix + m_name + "_" + key + ".off", pose, m_problem.triangles);
  }

  std::string m_name;
  const Body_problem& m_problem;
  std::string m_prefix;
  Eigen::VectorXd m_shares;
};

Body_problem problem_of_figure(const std::size_t vertices)
{
  const Articulated_figure figure(vertices);
  const auto points = figure.points(Articulated_figure::named_poses()[1].angles);
  Point_matrix matrix(static_cast<Eigen::Index>(points.size()), 3);
  for(std::size_t v = 0; v < points.size(); ++v)
    matrix.row(static_cast<Eigen::Index>(v)) << points[v][0], points[v][1], points[v][2];
  return prepare(matrix, figure.triangles());
}

Body_problem problem_of_file(const std::string& file)
{
  const Tool::Mesh_file mesh = Tool::read_mesh_file(file);
  const CP::Repaired_surface_3 surface
    = CP::repair_surface(Tool::matrix_of(Tool::points_of(mesh)), mesh.faces);
  return prepare(surface.points, surface.triangles, surface.caps);
}

// without folder and extension
std::string name_of(const std::string& file)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  return name.substr(0, name.find_last_of('.'));
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto vertices = static_cast<std::size_t>(arguments.take_number("--vertices", 10000));
    const double detail_length = arguments.take_number("--detail-length", 0.1);
    const std::string prefix = arguments.take_text("--prefix");
    const std::vector<std::string> files = arguments.rest();
    std::printf("| mesh | pose | strain | distance | volume | intersections |\n"
                "|---|---|---|---|---|---|\n");
    std::vector<std::pair<std::string, Body_problem>> problems; // before threads are created
    if(files.empty())
      problems.emplace_back("figure", problem_of_figure(vertices));
    for(const std::string& file : files)
      problems.emplace_back(name_of(file), problem_of_file(file));
    for(const auto& [name, problem] : problems)
      Comparison(name, problem, detail_length, prefix);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "energies_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
