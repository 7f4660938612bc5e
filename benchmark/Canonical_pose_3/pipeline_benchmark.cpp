// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Times of the entire pipeline, stage by stage, along with two references measured in the same run.
//
// How to read: the first column is canonical_pose_3() with a single registration, as in the paper:
// without rounds, and without untangling inverted cells; the other options are defaults. The second
// is the same with the body of TetGen; medians of --runs calls. Stages add up to the total; indented
// rows belong to the row above and are timed separately. The last row is the total with default
// options, including rounds.
// - Third column: the same distances by CGAL's Heat_method_3 (Intrinsic_Delaunay, its default
//   solver), from the same landmarks, one by one, but on the mesh itself instead of the coarse
//   surface. Timed once.
// - Fourth column: the registration of the second column exactly as printed in the paper
//   (Literal_registration.h), without acceleration and, except for the solver, on one thread: the
//   matrix is assembled and factored in every iteration, and rotations are computed by JacobiSVD.
//   All iterations required to converge without acceleration are run and timed, or the number given
//   by --literal: the time is then extrapolated, as stated below the table. The matrix has n rows
//   and three right-hand sides; another line states the time with the 3n rows of the paper.
// Totals of the references include their own time in the rows that they fill, and that of the first
// or second column in the others. Below the table, results are compared: mean difference of the
// distances, energies after the same number of iterations.
// Usage: pipeline_benchmark [--vertices 53000] [--runs 3] [--literal ITERATIONS] [mesh files]

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"
#include "Literal_registration.h"
#include "median.h"
#include "setting.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_benchmark::Literal_registration;
using Canonical_pose_benchmark::median;
using Canonical_pose_examples::Articulated_figure;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

struct Arguments
{
  std::size_t vertices = 53000;
  int runs = 3, literal = 0;
  std::vector<std::string> files;
};

template <class Function>
double seconds(const Function& f)
{
  CGAL::Real_timer timer;
  timer.start();
  f();
  return timer.time();
}

// The first two columns.
struct Ours
{
  CP::Result result;              // with the medians of the seconds
  CP::Registration_summary whole; // that with default options, of the last run
  double simplification = 0, set_up = 0, fields = 0, total_of_whole = 0;
};

Ours run_ours(const Mesh& mesh, const int runs, const CP::Options::Body body)
{
  Ours ours;
  std::vector<std::vector<double>> stages;
  std::vector<double> simplification, set_up, fields, total_of_whole;
  const CP::Prepared_surface_3 prepared = CP::prepare_surface(mesh);
  const CP::Surface_component_3& surface = prepared.components.front().surface;
  for(int run = 0; run < runs; ++run)
  {
    CP::Options options;
    options.body = body;
    Mesh pose = mesh;
    ours.whole = CGAL::canonical_pose_3(mesh, pose.points(), options).summary;
    total_of_whole.push_back(ours.whole.total_seconds());
    options.number_of_rounds = 0;
    options.registration.injective = false;
    options.return_landmark_fields = true;
    ours.result = CGAL::canonical_pose_3(mesh, pose.points(), options);
    stages.resize(ours.result.summary.stages.size());
    for(std::size_t s = 0; s < stages.size(); ++s)
      stages[s].push_back(ours.result.summary.stages[s].second);

    CGAL::Real_timer timer;
    timer.start();
    const CP::Coarse_surface_3 coarse
      = CP::coarse_surface(surface, CP::Component_options{options, {}});
    simplification.push_back(timer.time());
    const Mesh coarse_mesh
      = CP::make_triangle_mesh<Mesh>(coarse.surface.points, coarse.surface.triangles);
    timer.reset();
    const CP::Heat_geodesics_3<Mesh> geodesics(coarse_mesh);
    set_up.push_back(timer.time());
    const Mesh::Vertex_index first = CP::extremal_vertex(coarse_mesh, coarse_mesh.points());
    fields.push_back(seconds([&] { CP::front_landmarks(geodesics, 80, first); }));
  }
  for(std::size_t s = 0; s < stages.size(); ++s)
    ours.result.summary.stages[s].second = median(stages[s]);
  ours.simplification = median(simplification);
  ours.total_of_whole = median(total_of_whole);
  ours.set_up = median(set_up);
  ours.fields = median(fields);
  return ours;
}

// The third column.
struct Heat_method
{
  double set_up = 0, fields = 0;
  double difference = 0; // mean over vertices and sources, relative to the mean distance
};

Heat_method run_heat_method(const Mesh& input, const CP::Landmark_fields_3& ours)
{
  using Distances = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<
    Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;
  Heat_method result;
  Mesh mesh = input;
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
  CGAL::Real_timer timer;
  timer.start();
  Distances distances(mesh);
  result.set_up = timer.time();
  double difference = 0;
  for(std::size_t j = 0; j < ours.landmarks.size(); ++j)
  {
    result.fields += seconds([&] {
      distances.clear_sources();
      distances.add_source(Mesh::Vertex_index(Mesh::size_type(ours.landmarks[j])));
      distances.estimate_geodesic_distances(distance);
    });
    for(const Mesh::Vertex_index v : mesh.vertices())
      difference += std::abs(distance[v] - ours.distances(Eigen::Index(v), Eigen::Index(j)));
  }
  result.difference = difference / ours.distances.sum();
  return result;
}

// The fourth column, for one iteration.
struct Literal
{
  Literal_registration::Seconds per_iteration;
  double paper_size_per_iteration = 0; // with 3n rows
  int iterations = 0, iterations_to_converge = 0;
  double energy = 0, energy_of_ours = 0;
};

Literal run_literal(const Mesh& mesh, const CP::Intermediate_results& results,
                    const int requested_iterations)
{
  const CP::Conforming_body_3 body = CP::tetgen_body(mesh, mesh.points());
  const Eigen::VectorXd weights = CP::vertex_area_shares(mesh, mesh.points());
  const double length_scale = results.landmark_fields->distances.maxCoeff();
  CP::Registration_options options;
  options.acceleration_window = 0;
  options.injective = false; // as in the paper
  CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3> registrar(body, weights, length_scale,
                                                                    options);
  registrar.set_target(*results.target);
  registrar.set_number_of_iterations(0);
  CP::Point_matrix start, pose;
  registrar.register_to_target(start); // both start here

  Literal result;
  registrar.set_number_of_iterations(options.number_of_iterations);
  CP::Registration_summary ours = registrar.register_to_target(pose);
  result.iterations = result.iterations_to_converge = ours.iterations;
  if(requested_iterations > 0)
  {
    result.iterations = requested_iterations;
    registrar.set_number_of_iterations(requested_iterations);
    pose.resize(0, 3);
    ours = registrar.register_to_target(pose);
  }
  result.energy_of_ours = ours.energy;

  const double alpha = std::pow(options.detail_length * length_scale, 2);
  Literal_registration literal(body, weights, *results.target, alpha, 0,
                               Literal_registration::ONE_PER_VERTEX);
  CP::Point_matrix v = start;
  for(int k = 0; k < result.iterations; ++k)
    literal.iterate(v);
  result.energy = literal.energy(v) / (length_scale * length_scale);
  result.per_iteration = literal.seconds();
  result.per_iteration.rotations /= result.iterations;
  result.per_iteration.matrix /= result.iterations;
  result.per_iteration.solution /= result.iterations;

  Literal_registration large(body, weights, *results.target, alpha, 0,
                             Literal_registration::THREE_PER_VERTEX);
  v = start;
  for(int k = 0; k < 2; ++k)
    large.iterate(v);
  result.paper_size_per_iteration = large.seconds().total() / 2;
  return result;
}

void print_row(const std::string& name, const double ours, const double with_tetgen,
               const double heat = -1, const double literal = -1)
{
  std::printf("%-22s%14.3f%14.3f", name.c_str(), ours, with_tetgen);
  for(const double s : {heat, literal})
    s < 0 ? std::printf("%18s", "") : std::printf("%18.3f", s);
  std::printf("\n");
}

void print_table(const Ours& ours, const Ours& with_tetgen, const Heat_method& heat,
                 const Literal& literal)
{
  const double n = literal.iterations_to_converge;
  std::printf("%-22s%14s%14s%18s%18s\n", "seconds", "this package", "with TetGen",
              "CGAL heat method", "paper, literally");
  double total_heat = 0, total_literal = 0;
  for(std::size_t i = 0; i < ours.result.summary.stages.size(); ++i)
  {
    const auto& [stage, s] = ours.result.summary.stages[i];
    const double s_with_tetgen = with_tetgen.result.summary.stages[i].second;
    const double heat_here = stage == "geodesics" ? heat.set_up + heat.fields : -1;
    const double literal_here = stage == "factorization"  ? n * literal.per_iteration.matrix
                                : stage == "local_steps"  ? n * literal.per_iteration.rotations
                                : stage == "global_steps" ? n * literal.per_iteration.solution
                                                          : -1;
    print_row(stage, s, s_with_tetgen, heat_here, literal_here);
    total_heat += heat_here < 0 ? s : heat_here;
    total_literal += literal_here < 0 ? s_with_tetgen : literal_here;
    if(stage == "geodesics")
    {
      print_row("  coarse surface", ours.simplification, with_tetgen.simplification);
      print_row("  set-up", ours.set_up, with_tetgen.set_up, heat.set_up);
      print_row("  fields", ours.fields, with_tetgen.fields, heat.fields);
    }
  }
  print_row("total", ours.result.summary.total_seconds(),
            with_tetgen.result.summary.total_seconds(), total_heat, total_literal);
  print_row("total with rounds", ours.total_of_whole, with_tetgen.total_of_whole);
}

void compare(const std::string& name, const Mesh& mesh, const Arguments& arguments)
{
  const Ours ours = run_ours(mesh, arguments.runs, CP::Options::Body::AUTOMATIC);
  const Ours with_tetgen = run_ours(mesh, arguments.runs, CP::Options::Body::TETGEN);
  std::printf("\n%s: %zu vertices, %zu landmarks; median of %d runs\n", name.c_str(),
              std::size_t(mesh.number_of_vertices()), ours.result.summary.target.landmarks,
              arguments.runs);
  const Heat_method heat = run_heat_method(mesh, *ours.result.landmark_fields);
  const Literal literal = run_literal(mesh, with_tetgen.result, arguments.literal);
  print_table(ours, with_tetgen, heat, literal);
  std::printf("outcome: %s\n", ours.result.summary.brief_report().c_str());
  std::printf("outcome with TetGen: %s\n", with_tetgen.result.summary.brief_report().c_str());
  std::printf("outcome with rounds: %s\n", ours.whole.brief_report().c_str());
  std::printf("outcome with TetGen and rounds: %s\n", with_tetgen.whole.brief_report().c_str());
  std::printf("distances: ours differ from CGAL's by %.2f %% in the mean\n", 100 * heat.difference);
  std::printf("literal registration: %d iterations timed (%.3f s each) of the %d to convergence\n",
              literal.iterations, literal.per_iteration.total(), literal.iterations_to_converge);
  std::printf("  with the paper's 3n rows: %.3f s per iteration (2 timed), %.1f s for all\n",
              literal.paper_size_per_iteration,
              literal.iterations_to_converge * literal.paper_size_per_iteration);
  std::printf("  energy after %d iterations on one target, without acceleration: ours %.10f, "
              "literal %.10f, relative difference %.1e\n",
              literal.iterations, literal.energy_of_ours, literal.energy,
              std::abs(literal.energy / literal.energy_of_ours - 1));
}

Arguments read(const int argc, char** argv)
{
  Arguments arguments;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool has_value = i + 1 < argc;
    if(argument == "--vertices" && has_value)
      arguments.vertices = std::stoul(argv[++i]);
    else if(argument == "--runs" && has_value)
      arguments.runs = (std::max)(1, std::stoi(argv[++i]));
    else if(argument == "--literal" && has_value)
      arguments.literal = std::stoi(argv[++i]);
    else
      arguments.files.push_back(argument);
  }
  return arguments;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Arguments arguments = read(argc, argv);
    std::printf("%s\n", Canonical_pose_benchmark::setting().c_str());
    if(arguments.files.empty())
      compare("figure, sitting",
              Articulated_figure(arguments.vertices)
                .make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles),
              arguments);
    for(const std::string& file : arguments.files)
    {
      Mesh mesh;
      if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh))
        throw std::runtime_error("cannot read " + file);
      compare(file, mesh, arguments);
    }
  }
  catch(const std::exception& e)
  {
    std::cerr << "pipeline_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
