// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Times of the stages of canonical_pose_3() with its defaults, each called as the one call does: on the
// articulated figure, sitting, with 2 500, 10 000 and 53 000 vertices, or on the mesh files given.
//
// How to read: one line per stage and mesh. A stage begins with what those before it left. `geodesics` is the
// set-up for distances on the coarse surface, `fields` are 80 of them, with this set-up, and `target` is the
// first one; `one_iteration` is a local and a global step, averaged over twenty; `round_fields` and
// `round_target` are what a round adds: distances on the pose after these iterations, and the target that is
// refined with them. All others are one call. Compiler, flags and threads stand in the first lines.
// Usage: stages_benchmark [--benchmark_filter=<expression>] [other options of Google Benchmark] [mesh files]

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"
#include "setting.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Geodesics = CP::Heat_geodesics_3<Mesh>;
using Registrar = CP::Tetrahedral_arap_registrar_3<CP::Elastic_body_3>;
using Canonical_pose_examples::Articulated_figure;

namespace {

CP::Face_list polygons_of(const Mesh& mesh)
{
  CP::Face_list polygons;
  for(const Mesh::Face_index f : mesh.faces())
    polygons.push_back(mesh.vertices_around_face(mesh.halfedge(f)));
  return polygons;
}

// A surface, and what its stages leave for the next.
struct Surface
{
  explicit Surface(const Mesh& input)
    : points(CP::point_matrix(input)), polygons(polygons_of(input)),
      prepared(CP::prepare_surface(points, polygons)), surface(prepared.components.front().surface),
      options(prepared.components.front().options), coarse(CP::coarse_surface(surface, options)),
      mesh(CP::make_triangle_mesh<Mesh>(coarse.surface.points, coarse.surface.triangles)),
      fields(CP::landmark_fields(coarse, options)),
      target(CP::mds_target(surface, coarse, fields, options)),
      body(CP::surface_body(surface, coarse, fields, options)), pose(surface_pose()),
      posed(coarse.posed(pose)), fields_of_pose(CP::landmark_fields(posed, options))
  {}

  Surface(const Surface&) = delete; // some members refer to others

  // Inverted cells remain: to untangle them is no part of an iteration.
  Registrar registrar() const
  {
    CP::Registration_options registration;
    registration.energy_tolerance = registration.move_tolerance = 0;
    registration.number_of_iterations = 20;
    registration.injective = false;
    return Registrar(body.body, CP::vertex_area_shares(surface.points, surface.triangles),
                     body.length_scale, registration);
  }

  CP::Point_matrix surface_pose() const
  {
    Registrar registration = registrar();
    registration.set_target(target.points);
    CP::Point_matrix body_pose;
    registration.register_to_target(body_pose);
    return registration.surface_points(body_pose);
  }

  CP::Point_matrix points;
  CP::Face_list polygons;
  CP::Prepared_surface_3 prepared;
  const CP::Surface_component_3& surface;
  const CP::Component_options& options;
  CP::Coarse_surface_3 coarse;
  Mesh mesh; // the coarse surface
  CP::Landmark_fields_3 fields;
  CP::Target_3 target;
  CP::Surface_body_3 body;
  CP::Point_matrix pose;
  CP::Surface_component_3 posed; // the coarse surface in the pose
  CP::Landmark_fields_3 fields_of_pose;
};

void diagnosis(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::prepare_surface(s.points, s.polygons));
}

void coarse(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::coarse_surface(s.surface, s.options));
}

void geodesics(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(Geodesics(s.mesh).index(Mesh::Vertex_index(0)));
}

void fields(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::landmark_fields(s.coarse, s.options));
}

void target(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::mds_target(s.surface, s.coarse, s.fields, s.options));
}

void body(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::surface_body(s.surface, s.coarse, s.fields, s.options));
}

void round_fields(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::landmark_fields(s.posed, s.options));
}

void round_target(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(
      CP::refined_target(s.surface, s.coarse, s.fields_of_pose, s.pose, s.options));
}

void factorization(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
  {
    state.PauseTiming();
    Registrar registrar = s.registrar();
    state.ResumeTiming();
    registrar.factor();
  }
}

void one_iteration(benchmark::State& state, const Surface& s)
{
  Registrar registrar = s.registrar();
  registrar.set_target(s.target.points);
  for(auto _ : state)
  {
    CP::Point_matrix pose;
    const CP::Registration_summary summary = registrar.register_to_target(pose);
    double seconds = 0; // the energy of the start takes a local step more
    for(const auto& [stage, time] : summary.stages)
      seconds += stage == "local_steps" ? time / 21 : stage == "global_steps" ? time / 20 : 0;
    state.SetIterationTime(seconds);
  }
}

// The surface is made when the first of its stages runs.
void register_stages(const std::string& name, const std::function<Mesh()>& make_mesh)
{
  const auto surface = std::make_shared<std::unique_ptr<Surface>>();
  const auto add = [&](const char* stage, void (*f)(benchmark::State&, const Surface&)) {
    return benchmark::RegisterBenchmark((name + '/' + stage).c_str(),
                                        [=](benchmark::State& state) {
                                          if(!*surface)
                                            *surface = std::make_unique<Surface>(make_mesh());
                                          f(state, **surface);
                                        })
      ->Unit(benchmark::kMillisecond);
  };
  add("diagnosis", diagnosis)->UseRealTime();
  add("coarse", coarse)->UseRealTime();
  add("geodesics", geodesics)->UseRealTime();
  add("fields", fields)->UseRealTime();
  add("target", target)->UseRealTime();
  add("body", body)->UseRealTime();
  add("factorization", factorization)->UseRealTime();
  add("one_iteration", one_iteration)->UseManualTime();
  add("round_fields", round_fields)->UseRealTime();
  add("round_target", round_target)->UseRealTime();
}

Mesh read(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    benchmark::Initialize(&argc, argv);
    benchmark::AddCustomContext("setting", Canonical_pose_benchmark::setting());
    const std::vector<std::string> files(argv + 1, argv + argc);
    for(const std::string& file : files)
      register_stages(file.substr(file.find_last_of('/') + 1), [file] { return read(file); });
    if(files.empty())
      for(const std::size_t n : {2500, 10000, 53000})
        register_stages("figure/" + std::to_string(n), [n] {
          return Articulated_figure(n).make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles);
        });
    benchmark::RunSpecifiedBenchmarks();
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "stages_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
