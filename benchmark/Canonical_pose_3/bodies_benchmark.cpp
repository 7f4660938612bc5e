// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bodies: the cost and quality of each kind of elastic body, on the figure in its five named poses
// or the given mesh files, and whether it glues separate parts together.
//
// How to read: three tables in Markdown. Targets are the first ones of the package with its defaults,
// the same for all bodies; each body is created and registered in a separate process, once, and
// inverted cells are not untangled.
// 1. Costs and results. `nonzeros`: entries of the Cholesky factor, in millions (CHOLMOD only); `MB`:
//    peak memory of body and registration; `ms`: per iteration; `strain`: median of |log(edge length
//    in the pose / in the input)|; `difference`: to the pose with the body of TetGen, root mean
//    square after the best rigid motion, at unit radius of gyration.
// 2. Mean difference of the poses of all pairs of meshes, if these have corresponding vertices.
// 3. Gluing, on shapes by formula.
//    - Two fingers of radius 0.4, the target far apart: distance of the tips in the pose by that in
//      the target. Near 1 is correct; less if the body glues them.
//    - A plate of thickness 1/200 with its own target, which would blow it up: largest relative
//      change of the thickness in the pose. A body that falls into two gives far more than 0.
//    - A torus with a narrow hole, the target being the torus itself: root mean square distance of
//      pose and target, by L, which ought to be 0; Euler characteristic of the body (0 with one
//      hole, if the cells fit together); largest distance of the centroid of a cell to the solid,
//      by L: at most about a cell if the hole is not bridged.
// TetGen requires surfaces without defects and is skipped otherwise; its time is that
// of tetgen_body(), which looks for defects first.
// Usage: bodies_benchmark [--vertices 10000] [mesh files]

#include <CGAL/Canonical_pose_3/repair_surface.h>

#include "Argument_list.h"
#include "Body_trial.h"
#include "gluing_shapes.h"
#include "mean_difference.h"
#include "prepare.h"
#include "setting.h"

#include "formats/Cgal_types.h" // of the tool

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Tool = Canonical_pose_tool;
using namespace Canonical_pose_benchmark;
using Canonical_pose_examples::Articulated_figure;

namespace {

std::string without_folder(const std::string& name)
{
  return name.substr(name.find_last_of('/') + 1);
}

// The first two tables.
class Comparison
{
public:
  Comparison()
  {
    std::printf("| mesh | vertices | body | body vertices | cells | nonzeros | MB | body s | "
                "factorization s | ms | iterations | energy | strain | inverted | difference |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  }

  void add(const std::string& name, const Body_problem& problem)
  {
    m_inputs.push_back(problem.points);
    m_targets.push_back(problem.target);
    Point_matrix reference;
    for(const Body_kind kind : all_bodies)
    {
      const Body_trial trial = try_body(kind, problem);
      std::printf("| %s | %td | %s | ", name.c_str(), std::ptrdiff_t(problem.points.rows()),
                  Canonical_pose_benchmark::name(kind));
      print(trial, reference);
      std::fflush(stdout);
      if(!trial.failure.empty())
        continue;
      m_poses[kind].push_back(trial.pose);
      if(kind == Body_kind::TETGEN)
        reference = trial.pose;
    }
  }

  void print_differences() const
  {
    std::printf("\n| mean difference of all pairs | meshes | |\n|---|---|---|\n");
    print("input", m_inputs);
    print("target", m_targets);
    for(const auto& [kind, poses] : m_poses)
      print(std::string("pose, ") + name(kind), poses);
  }

private:
  static void print(const Body_trial& trial, const Point_matrix& reference)
  {
    const Body_trial::Numbers& n = trial.numbers;
    if(!trial.failure.empty())
      std::printf("%s | | | | | | | | | | | |\n", trial.failure.c_str());
    else
      std::printf(
        "%zu | %zu | %.2f | %.0f | %.3f | %.3f | %.2f | %d | %.6f | %.4f | %zu | %s |\n",
        n.vertices, n.cells, 1e-6 * static_cast<double>(n.nonzeros), trial.megabytes,
        n.body_seconds, n.factorization_seconds, 1000 * n.iteration_seconds, n.iterations, n.energy,
        n.strain, n.inverted,
        reference.rows() == 0
          ? ""
          : std::to_string(CP::pose_difference(trial.pose, reference)).substr(0, 6).c_str());
  }

  static void print(const std::string& what, const std::vector<Point_matrix>& poses)
  {
    if(poses.size() > 1)
      std::printf("| %s | %zu | %.4f |\n", what.c_str(), poses.size(), mean_difference(poses));
  }

  std::vector<Point_matrix> m_inputs, m_targets;
  std::map<Body_kind, std::vector<Point_matrix>> m_poses;
};

Point_matrix matrix_of(const Points& points)
{
  Point_matrix result(static_cast<Eigen::Index>(points.size()), 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1], points[i][2];
  return result;
}

// Prints a row of the third table for each body; `measure` returns the last two columns.
template <class Function>
void print_gluing(const char* shape, const Body_problem& problem, const Function& measure)
{
  for(const Body_kind kind : all_bodies)
  {
    const Body_trial trial = try_body(kind, problem);
    std::printf("| %s | %s | ", shape, name(kind));
    if(trial.failure.empty())
      measure(trial);
    else
      std::printf("%s", trial.failure.c_str());
    std::printf(" | %zu |\n", trial.numbers.inverted);
    std::fflush(stdout);
  }
}

void print_fingers(const char* shape, const double angle)
{
  const Two_fingers fingers;
  const Triangle_soup soup = fingers.bent(angle);
  Body_problem problem = prepare(matrix_of(soup.points), soup.triangles);
  problem.target = matrix_of(fingers.bent(pi / 2).points);
  const auto tip_distance = [&](const Point_matrix& points) {
    return (points.row(fingers.tips()[0]) - points.row(fingers.tips()[1])).norm();
  };
  print_gluing(shape, problem, [&](const Body_trial& trial) {
    std::printf("distance of the tips %.4f",
                tip_distance(trial.pose) / tip_distance(problem.target));
  });
}

void print_plate()
{
  const Triangle_soup soup = thin_plate();
  const Body_problem problem = prepare(matrix_of(soup.points), soup.triangles);
  const Eigen::Index half = problem.points.rows() / 2;
  const auto thickness = [&](const Point_matrix& points) -> Eigen::VectorXd {
    return (points.topRows(half) - points.bottomRows(half)).rowwise().norm();
  };
  print_gluing("thin plate", problem, [&](const Body_trial& trial) {
    const Eigen::VectorXd ratio = thickness(trial.pose).cwiseQuotient(thickness(problem.points));
    std::printf("change of thickness %.4f", (ratio.array() - 1).abs().maxCoeff());
  });
}

void print_torus()
{
  const Triangle_soup soup = Narrow_torus::surface();
  Body_problem problem = prepare(matrix_of(soup.points), soup.triangles);
  problem.target = problem.points;
  problem.distance_outside = Narrow_torus::distance_outside;
  print_gluing("torus", problem, [&](const Body_trial& trial) {
    const double rms = std::sqrt((trial.pose - problem.target).rowwise().squaredNorm().mean());
    std::printf(
      "distance to the target %.1e, Euler characteristic %lld, farthest cell outside %.4f",
      rms / problem.length_scale(), trial.numbers.euler_characteristic,
      trial.numbers.farthest_outside / problem.length_scale());
  });
}

void print_gluing()
{
  std::printf("\n| shape | body | | inverted |\n|---|---|---|---|\n");
  const Two_fingers fingers;
  print_fingers("fingers side by side", pi);
  print_fingers("fingers nearly touch", fingers.angle_of(0.81));
  print_fingers("fingers overlap", fingers.angle_of(0.4));
  print_fingers("fingers go through each other", fingers.angle_of(-1));
  print_plate();
  print_torus();
}

void compare_figure(const std::size_t vertices, Comparison& comparison)
{
  const Articulated_figure figure(vertices);
  for(const auto& pose : Articulated_figure::named_poses())
    comparison.add(pose.name, prepare(matrix_of(figure.points(pose.angles)), figure.triangles()));
}

void compare_file(const std::string& file, Comparison& comparison)
{
  const Tool::Mesh_file mesh = Tool::read_mesh_file(file);
  const CP::Repaired_surface_3 surface
    = CP::repair_surface(Tool::matrix_of(Tool::points_of(mesh)), mesh.faces);
  comparison.add(without_folder(file), prepare(surface.points, surface.triangles, surface.caps));
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto vertices = static_cast<std::size_t>(arguments.take_number("--vertices", 10000));
    const std::vector<std::string> files = arguments.rest();
    std::printf("%s\n\n", setting().c_str());
    Comparison comparison;
    if(files.empty())
      compare_figure(vertices, comparison);
    for(const std::string& file : files)
      compare_file(file, comparison);
    comparison.print_differences();
    if(files.empty())
      print_gluing();
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "bodies_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
