// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Body_trial.h"

#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/mesh_3_body.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#endif
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <CGAL/Real_timer.h>

#include "Child_process.h"
#include "Chord_tetrahedra.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <stdexcept>
#include <type_traits>

namespace Canonical_pose_benchmark {

namespace {

// Number of entries of the Cholesky factor of the registration; 0 if it is not known.
template <class ElasticBody>
std::size_t factor_nonzeros(const ElasticBody& body)
{
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  std::vector<Eigen::Triplet<double>> entries;
  for(const std::array<int, 4>& cell : body.cells())
    for(const int i : cell)
      for(const int j : cell)
        entries.emplace_back(i, j, 1);
  Eigen::SparseMatrix<double> pattern(body.points().rows(), body.points().rows());
  pattern.setFromTriplets(entries.begin(), entries.end());
  pattern += Eigen::SparseMatrix<double>(body.embedding().transpose() * body.embedding());
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> solver;
  solver.analyzePattern(pattern);
  return static_cast<std::size_t>(solver.cholmod().lnz);
#else
  static_cast<void>(body);
  return 0;
#endif
}

// Calls `use` with the body.
template <class Function>
void with_body(const Body_kind kind, const Body_problem& problem, const Function& use)
{
  namespace CP = CGAL::Canonical_pose_3;
  switch(kind)
  {
  case Body_kind::TETGEN: {
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
    using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
    const Mesh mesh = CP::make_triangle_mesh<Mesh>(problem.points, problem.triangles);
    use([&] { return CP::tetgen_body(mesh, mesh.points()); });
#else
    throw std::invalid_argument("built without TetGen");
#endif
    break;
  }
  case Body_kind::LATTICE:
    use([&] {
      return CP::Lattice_body_3(problem.points, problem.triangles, problem.distances, 0,
                                problem.caps);
    });
    break;
  case Body_kind::MESH_3:
    use([&] { return CP::mesh_3_body(problem.points, problem.triangles, problem.length_scale()); });
    break;
  case Body_kind::CHORDS:
    use([&] {
      return chord_tetrahedra(problem.points, problem.triangles, problem.caps, problem.distances,
                              problem.length_scale());
    });
    break;
  }
}

long long euler_characteristic(const std::vector<std::array<int, 4>>& cells)
{
  std::set<std::array<int, 2>> edges;
  std::set<std::array<int, 3>> facets;
  std::set<int> vertices;
  for(std::array<int, 4> cell : cells)
  {
    std::sort(cell.begin(), cell.end());
    for(int i = 0; i < 4; ++i)
    {
      vertices.insert(cell[i]);
      facets.insert({cell[i == 0 ? 1 : 0], cell[i <= 1 ? 2 : 1], cell[i <= 2 ? 3 : 2]});
      for(int j = 0; j < i; ++j)
        edges.insert({cell[j], cell[i]});
    }
  }
  return static_cast<long long>(vertices.size()) - static_cast<long long>(edges.size())
         + static_cast<long long>(facets.size()) - static_cast<long long>(cells.size());
}

double farthest_outside(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                        const Body_problem& problem)
{
  double result = 0;
  if(problem.distance_outside)
    for(const std::array<int, 4>& cell : cells)
    {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for(const int v : cell)
        sum += points.row(v);
      result = (std::max)(result, problem.distance_outside(sum / 4));
    }
  return result;
}

// Runs in the child. Returns the bytes of the numbers and of the pose.
std::string try_body_here(const Body_kind kind, const Body_problem& problem)
{
  namespace CP = CGAL::Canonical_pose_3;
  Body_trial::Numbers numbers = {};
  Point_matrix pose;
  with_body(kind, problem, [&](const auto& make_body) {
    CGAL::Real_timer timer;
    timer.start();
    const auto body = make_body();
    numbers.body_seconds = timer.time();
    CP::Registration_options options;
    options.injective = false; // inverted cells are counted
    CP::Tetrahedral_arap_registrar_3<std::decay_t<decltype(body)>> registrar(
      body, CP::vertex_area_shares(problem.points, problem.triangles), problem.length_scale(),
      options);
    registrar.set_target(problem.target);
    Point_matrix body_pose;
    const CP::Registration_summary summary = registrar.register_to_target(body_pose);
    if(!summary.is_usable())
      throw std::runtime_error("the registration met numbers that are not finite");
    pose = registrar.surface_points(body_pose);
    numbers.vertices = summary.body.vertices;
    numbers.cells = summary.body.tetrahedra;
    numbers.inverted = summary.inverted;
    numbers.iterations = summary.iterations;
    numbers.energy = summary.energy;
    for(const auto& [stage, seconds] : summary.stages)
      (stage == "factorization" ? numbers.factorization_seconds : numbers.iteration_seconds)
        += seconds / (stage == "factorization" ? 1 : summary.iterations);
    numbers.strain = CP::median_edge_strain(problem.points, pose, problem.triangles);
    numbers.nonzeros = factor_nonzeros(body);
    if(problem.distance_outside)
    {
      numbers.euler_characteristic = euler_characteristic(body.cells());
      numbers.farthest_outside = farthest_outside(body.points(), body.cells(), problem);
    }
  });
  std::string bytes(reinterpret_cast<const char*>(&numbers), sizeof(numbers));
  return bytes.append(reinterpret_cast<const char*>(pose.data()),
                      sizeof(double) * static_cast<std::size_t>(pose.size()));
}

} // namespace

Body_trial try_body(const Body_kind kind, const Body_problem& problem)
{
  Child_process idle([] { return std::string(); }, Limits());
  idle.wait();
  Child_process child([&] { return try_body_here(kind, problem); }, Limits{600, 0});
  child.wait();
  Body_trial result;
  result.megabytes = child.peak_megabytes() - idle.peak_megabytes();
  if(child.ending() != Child_process::RETURNED)
  {
    result.failure = child.description();
    return result;
  }
  std::memcpy(&result.numbers, child.output().data(), sizeof(result.numbers));
  result.pose.resize(problem.points.rows(), 3);
  std::memcpy(result.pose.data(), child.output().data() + sizeof(result.numbers),
              sizeof(double) * static_cast<std::size_t>(result.pose.size()));
  return result;
}

} // namespace Canonical_pose_benchmark
