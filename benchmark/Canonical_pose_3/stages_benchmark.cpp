// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Times of single stages, on the articulated figure with 2 500, 10 000 and 53 000 vertices.
//
// How to read: one line per stage and size. All but `landmark_fields` (80 fields, chosen one after
// the other), `batch_of_80_fields` and `one_iteration` are one call. `one_iteration` is a local and
// a global step, averaged over twenty. Linear stages (diagnosis, target, tetgen_body,
// one_iteration) take about five times as long from 10 000 to 53 000 vertices, factorisations
// somewhat more. Compiler, flags and threads stand in the first lines.
// Usage: stages_benchmark [--benchmark_filter=<expression>] [other options of Google Benchmark]

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/tetgen_body.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"
#include "setting.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Geodesics = CP::Heat_geodesics_3<Mesh>;
using Registrar = CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3>;
using Canonical_pose_examples::Articulated_figure;

namespace {

// The figure of one size, and what the stages leave for the next.
struct Figure
{
  explicit Figure(const std::size_t n)
    : mesh(Articulated_figure(n).make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles)),
      points(CP::point_matrix(mesh)), shares(CP::vertex_area_shares(mesh, mesh.points())),
      geodesics(mesh), fields(CP::farthest_point_landmarks(geodesics, 80, Mesh::Vertex_index(0))),
      body(CP::tetgen_body(mesh, mesh.points()))
  {}

  CP::Point_matrix target() const
  {
    CP::Landmark_mds_target_builder_3<> builder;
    builder.build(fields);
    return CP::align_target(builder.targets(), points, shares);
  }

  Registrar registrar() const
  {
    CP::Registration_options options;
    options.energy_tolerance = options.move_tolerance = 0;
    return Registrar(body, shares, fields.distances.maxCoeff(), options);
  }

  Mesh mesh;
  CP::Point_matrix points;
  Eigen::VectorXd shares;
  Geodesics geodesics;
  CP::Landmark_fields_3 fields;
  CP::Conforming_body_3 body;
};

const Figure& figure(const benchmark::State& state)
{
  static std::map<std::size_t, std::unique_ptr<Figure>> figures;
  std::unique_ptr<Figure>& result = figures[static_cast<std::size_t>(state.range(0))];
  if(!result)
    result = std::make_unique<Figure>(static_cast<std::size_t>(state.range(0)));
  return *result;
}

void diagnosis(benchmark::State& state)
{
  const Figure& f = figure(state);
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::diagnose(f.mesh, f.mesh.points()));
}

void geodesics_set_up(benchmark::State& state)
{
  const Figure& f = figure(state);
  for(auto _ : state)
    benchmark::DoNotOptimize(Geodesics(f.mesh).index(Mesh::Vertex_index(0)));
}

void one_field(benchmark::State& state)
{
  const Figure& f = figure(state);
  for(auto _ : state)
    benchmark::DoNotOptimize(f.geodesics.distances(Mesh::Vertex_index(0)));
}

void batch_of_80_fields(benchmark::State& state)
{
  const Figure& f = figure(state);
  std::vector<Mesh::Vertex_index> sources;
  for(const std::size_t l : f.fields.landmarks)
    sources.emplace_back(static_cast<Mesh::size_type>(l));
  for(auto _ : state)
    benchmark::DoNotOptimize(f.geodesics.distances(sources));
}

void landmark_fields(benchmark::State& state)
{
  const Figure& f = figure(state);
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::farthest_point_landmarks(f.geodesics, 80, Mesh::Vertex_index(0)));
}

void target(benchmark::State& state)
{
  const Figure& f = figure(state);
  for(auto _ : state)
    benchmark::DoNotOptimize(f.target());
}

void tetgen_body(benchmark::State& state) // without the diagnosis
{
  const Figure& f = figure(state);
  const auto triangles = CP::internal::index_triangles(f.mesh);
  for(auto _ : state)
    benchmark::DoNotOptimize(CP::internal::tetgen_body_of_clean_surface(f.points, triangles));
}

void factorization(benchmark::State& state)
{
  const Figure& f = figure(state);
  for(auto _ : state)
  {
    state.PauseTiming();
    Registrar registrar = f.registrar();
    state.ResumeTiming();
    registrar.factor();
  }
}

void one_iteration(benchmark::State& state)
{
  const Figure& f = figure(state);
  Registrar registrar = f.registrar();
  registrar.set_target(f.target());
  registrar.set_number_of_iterations(20);
  CP::Point_matrix pose = f.body.points();
  for(auto _ : state)
  {
    const CP::Registration_summary summary = registrar.register_to_target(pose);
    double seconds = 0; // the energy of the start takes a local step more
    for(const auto& [stage, s] : summary.stages)
      seconds += stage == "local_steps" ? s / 21 : stage == "global_steps" ? s / 20 : 0;
    state.SetIterationTime(seconds);
  }
}

} // namespace

#define CANONICAL_POSE_3_STAGE(name)                                                               \
  BENCHMARK(name)->Arg(2500)->Arg(10000)->Arg(53000)->Unit(benchmark::kMillisecond)

CANONICAL_POSE_3_STAGE(diagnosis)->UseRealTime();
CANONICAL_POSE_3_STAGE(geodesics_set_up)->UseRealTime();
CANONICAL_POSE_3_STAGE(one_field)->UseRealTime();
CANONICAL_POSE_3_STAGE(batch_of_80_fields)->UseRealTime();
CANONICAL_POSE_3_STAGE(landmark_fields)->UseRealTime();
CANONICAL_POSE_3_STAGE(target)->UseRealTime();
CANONICAL_POSE_3_STAGE(tetgen_body)->UseRealTime();
CANONICAL_POSE_3_STAGE(factorization)->UseRealTime();
CANONICAL_POSE_3_STAGE(one_iteration)->UseManualTime();

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if(benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::AddCustomContext("setting", Canonical_pose_benchmark::setting());
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
