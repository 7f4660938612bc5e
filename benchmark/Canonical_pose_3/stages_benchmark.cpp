// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Times of the stages of canonical_pose_3() with its defaults, each called as the one call does: on the
// articulated figure, sitting, with 2 500, 10 000 and 53 000 vertices, or on the mesh files given.
//
// How to read: one line per stage and mesh. A stage begins with what those before it left. `fields` are 80 of
// them, chosen one after the other; `one_iteration` is a local and a global step, averaged over twenty; all
// others are one call. Compiler, flags and threads stand in the first lines.
// Usage: stages_benchmark [--benchmark_filter=<expression>] [other options of Google Benchmark] [mesh files]

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

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
using Registrar = CP::Tetrahedral_arap_registrar_3<CP::Lattice_body_3>;
using Canonical_pose_examples::Articulated_figure;

namespace {

std::vector<std::vector<std::size_t>> polygons_of(const Mesh& mesh)
{
  std::vector<std::vector<std::size_t>> polygons;
  for(const Mesh::Face_index f : mesh.faces())
  {
    polygons.emplace_back();
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      polygons.back().push_back(v);
  }
  return polygons;
}

// A surface, and what its stages leave for the next.
struct Surface
{
  explicit Surface(const Mesh& input)
    : points(CP::point_matrix(input)), polygons(polygons_of(input)),
      repaired(CP::repair_surface(points, polygons)),
      mesh(CP::make_triangle_mesh<Mesh>(repaired.points, repaired.triangles)),
      first(CP::extremal_vertex(mesh, mesh.points())), geodesics(mesh),
      fields(CP::front_landmarks(geodesics, 80, first)),
      shares(CP::vertex_area_shares(repaired.points, repaired.triangles)), body(lattice())
  {}

  CP::Point_matrix target() const
  {
    CP::Landmark_mds_target_builder_3<> builder;
    builder.build(fields);
    auto closed = repaired.triangles;
    closed.insert(closed.end(), repaired.caps.begin(), repaired.caps.end());
    const bool is_mirrored
      = CP::target_handedness(builder.targets(), repaired.points, closed, shares) < 0;
    return CP::align_target(builder.targets(), repaired.points, shares, is_mirrored);
  }

  CP::Lattice_body_3 lattice() const
  {
    return CP::Lattice_body_3(repaired.points, repaired.triangles, fields.distances, 0,
                              repaired.caps);
  }

  Registrar registrar() const
  {
    CP::Registration_options options;
    options.energy_tolerance = options.move_tolerance = 0;
    options.number_of_iterations = 20;
    return Registrar(body, shares, fields.distances.maxCoeff(), options);
  }

  CP::Point_matrix points;
  std::vector<std::vector<std::size_t>> polygons;
  CP::Repaired_surface_3 repaired;
  Mesh mesh;
  Mesh::Vertex_index first;
  Geodesics geodesics;
  CP::Landmark_fields_3 fields;
  Eigen::VectorXd shares;
  CP::Lattice_body_3 body;
};

void diagnosis(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
  {
    benchmark::DoNotOptimize(CP::diagnose(s.points, s.polygons));
    benchmark::DoNotOptimize(CP::repair_surface(s.points, s.polygons));
  }
}

void geodesics(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(Geodesics(s.mesh).index(s.first));
}

void fields(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::front_landmarks(s.geodesics, 80, s.first));
}

void body(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(s.lattice());
}

void target(benchmark::State& state, const Surface& s)
{
  for(auto _ : state)
    benchmark::DoNotOptimize(s.target());
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
  registrar.set_target(s.target());
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
  add("geodesics", geodesics)->UseRealTime();
  add("fields", fields)->UseRealTime();
  add("body", body)->UseRealTime();
  add("target", target)->UseRealTime();
  add("factorization", factorization)->UseRealTime();
  add("one_iteration", one_iteration)->UseManualTime();
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
