// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Times of the one call and of what can be assembled for the same purpose from CGAL, TetGen and
// libigl, by turns.
//
// How to read: seconds, medians over --runs, and the ratio to the first row of each group, the
// median of the ratios of single runs.
// - assembled: CGAL's Heat_method_3 (Intrinsic_Delaunay) from 80 farthest points, the target of
//   this package, TetGen, and as many iterations of local steps (igl::fit_rotations) and global
//   steps (igl::min_quad_with_fixed, factored once) as the call without rounds takes, with the same
//   weights and the same target term.
// - `--rounds 0`: the call without measuring distances again, so the same work as the assembled
//   pipeline.
// The last rows are distances from 80 sources, setup included.
//
// Usage: peers_benchmark [--vertices 50000] [--runs 3] [mesh files]

#include "Argument_list.h"
#include "median.h"
#include "setting.h"
#include "spread_sources.h"

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <igl/ARAPEnergyType.h>
#include <igl/arap_rhs.h>
#include <igl/columnize.h>
#include <igl/cotmatrix.h>
#include <igl/covariance_scatter_matrix.h>
#include <igl/fit_rotations.h>
#include <igl/heat_geodesics.h>
#include <igl/min_quad_with_fixed.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_benchmark;
using Canonical_pose_examples::Articulated_figure;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Heat_of_cgal
  = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh,
                                                           CGAL::Heat_method_3::Intrinsic_Delaunay>;

namespace {

constexpr std::size_t NUMBER_OF_LANDMARKS = 80;

// The distances of CGAL's heat method from one source after another, each chosen by the function from the ones before.
CP::Landmark_fields_3
fields_of_cgal(const Mesh& input,
               const std::function<Mesh::Vertex_index(const CP::Landmark_fields_3&)>& next)
{
  Mesh mesh = input;
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
  Heat_of_cgal heat(mesh);
  CP::Landmark_fields_3 result;
  result.distances.resize(Eigen::Index(mesh.number_of_vertices()), NUMBER_OF_LANDMARKS);
  for(std::size_t j = 0; j < NUMBER_OF_LANDMARKS; ++j)
  {
    const Mesh::Vertex_index source = next(result);
    heat.clear_sources();
    heat.add_source(source);
    heat.estimate_geodesic_distances(distance);
    result.landmarks.push_back(source);
    for(const Mesh::Vertex_index v : mesh.vertices())
      result.distances(Eigen::Index(v), Eigen::Index(j)) = distance[v];
  }
  return result;
}

CP::Landmark_fields_3 farthest_points_of_cgal(const Mesh& mesh)
{
  const auto farthest = [&](const CP::Landmark_fields_3& fields) {
    if(fields.landmarks.empty())
      return CP::extremal_vertex(mesh, mesh.points());
    Eigen::Index v;
    fields.distances.leftCols(Eigen::Index(fields.landmarks.size()))
      .rowwise()
      .minCoeff()
      .maxCoeff(&v);
    return Mesh::Vertex_index(Mesh::size_type(v));
  };
  return fields_of_cgal(mesh, farthest);
}

// Returns the pose of a body, by libigl: minimizes the sum over the surface of w |v - t|^2 plus alpha times the mean of
// |F - R|^2 over the volume.
CP::Point_matrix registration_of_libigl(const CP::Conforming_body_3& body,
                                        const Eigen::VectorXd& weights,
                                        const CP::Point_matrix& target, const double alpha,
                                        const int number_of_iterations)
{
  const Eigen::MatrixXd points = body.points();
  const Eigen::Index n = points.rows();
  Eigen::MatrixXi cells(Eigen::Index(body.cells().size()), 4);
  for(Eigen::Index c = 0; c < cells.rows(); ++c)
    for(Eigen::Index k = 0; k < 4; ++k)
      cells(c, k) = body.cells()[std::size_t(c)][std::size_t(k)];
  const double weight_of_cells = alpha / body.volume();
  Eigen::VectorXd weights_of_points = Eigen::VectorXd::Zero(n);
  weights_of_points.head(weights.size()) = weights;
  Eigen::MatrixXd attraction = Eigen::MatrixXd::Zero(n, 3);
  attraction.topRows(target.rows()) = weights.asDiagonal() * target;

  Eigen::SparseMatrix<double> laplacian, scatter, rest;
  igl::cotmatrix(points, cells, laplacian);
  igl::covariance_scatter_matrix(points, cells, igl::ARAP_ENERGY_TYPE_ELEMENTS, scatter);
  igl::arap_rhs(points, cells, 3, igl::ARAP_ENERGY_TYPE_ELEMENTS, rest);
  Eigen::SparseMatrix<double> matrix = -weight_of_cells * laplacian;
  matrix.diagonal() += weights_of_points;
  igl::min_quad_with_fixed_data<double> solver;
  igl::min_quad_with_fixed_precompute(matrix, Eigen::VectorXi(), Eigen::SparseMatrix<double>(),
                                      true, solver);

  Eigen::MatrixXd pose = points;
  for(int iteration = 0; iteration < number_of_iterations; ++iteration)
  {
    Eigen::MatrixXd covariances = scatter * pose.replicate(3, 1);
    covariances /= covariances.array().abs().maxCoeff();
    Eigen::MatrixXd rotations(3, scatter.rows());
    igl::fit_rotations(covariances, true, rotations);
    Eigen::VectorXd column;
    igl::columnize(rotations, int(rest.cols() / 9), 2, column);
    const Eigen::VectorXd linear = -weight_of_cells * (rest * column);
    for(int k = 0; k < 3; ++k)
    {
      Eigen::VectorXd solution;
      igl::min_quad_with_fixed_solve(solver,
                                     Eigen::VectorXd(linear.segment(k * n, n) - attraction.col(k)),
                                     Eigen::VectorXd(), Eigen::VectorXd(), solution);
      pose.col(k) = solution;
    }
  }
  return pose;
}

CP::Point_matrix assembled(const Mesh& mesh, const int number_of_iterations)
{
  const CP::Landmark_fields_3 fields = farthest_points_of_cgal(mesh);
  CP::Landmark_mds_target_builder_3 builder;
  builder.build(fields);
  const Eigen::VectorXd weights = CP::vertex_area_shares(mesh, mesh.points());
  const CP::Conforming_body_3 body = CP::tetgen_body(mesh, mesh.points());
  const CP::Point_matrix target = CP::align_target(
    builder.targets(), CP::Point_matrix(body.points().topRows(weights.size())), weights);
  const double detail_length
    = CP::Registration_options().detail_length * fields.distances.maxCoeff();
  return registration_of_libigl(body, weights, target, detail_length * detail_length,
                                number_of_iterations);
}

void heat_of_libigl(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sources)
{
  const Eigen::MatrixXd points = CP::point_matrix(mesh, mesh.points());
  Eigen::MatrixXi faces(Eigen::Index(mesh.number_of_faces()), 3);
  for(const Mesh::Face_index f : mesh.faces())
  {
    Eigen::Index k = 0;
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      faces(Eigen::Index(f), k++) = int(v);
  }
  igl::HeatGeodesicsData<double> data;
  data.use_intrinsic_delaunay = true;
  igl::heat_geodesics_precompute(points, faces, data);
  Eigen::MatrixXd result(points.rows(), Eigen::Index(sources.size()));
  for(std::size_t j = 0; j < sources.size(); ++j)
  {
    Eigen::VectorXd distances;
    igl::heat_geodesics_solve(data, Eigen::VectorXi(Eigen::VectorXi::Constant(1, int(sources[j]))),
                              distances);
    result.col(Eigen::Index(j)) = distances;
  }
}

struct Contestant
{
  std::string name;
  std::function<void()> run;
};

// Lets them run by turns; ratios are to the first one.
void compare(const std::vector<Contestant>& contestants, const std::size_t runs)
{
  std::vector<std::vector<double>> seconds(contestants.size()), ratios(contestants.size());
  for(std::size_t run = 0; run < runs; ++run)
    for(std::size_t i = 0; i < contestants.size(); ++i)
    {
      CGAL::Real_timer timer;
      timer.start();
      contestants[i].run();
      seconds[i].push_back(timer.time());
      ratios[i].push_back(seconds[i].back() / seconds[0].back());
    }
  for(std::size_t i = 0; i < contestants.size(); ++i)
    std::printf("  %-44s%9.2f s%8.2f\n", contestants[i].name.c_str(), median(seconds[i]),
                median(ratios[i]));
  std::fflush(stdout);
}

void compare(const std::string& name, const Mesh& mesh, const std::size_t runs)
{
  std::printf("\n%s, %zu vertices\n", name.c_str(), std::size_t(mesh.number_of_vertices()));
  CP::Options single;
  single.number_of_rounds = 0;
  Mesh pose = mesh;
  const int iterations = CGAL::canonical_pose_3(mesh, pose.points(), single).summary.iterations;
  compare({{"the call", [&] { CGAL::canonical_pose_3(mesh, pose.points()); }},
           {"assembled, " + std::to_string(iterations) + " iterations",
            [&] { assembled(mesh, iterations); }}},
          runs);
  compare({{"the call, --rounds 0", [&] { CGAL::canonical_pose_3(mesh, pose.points(), single); }},
           {"assembled", [&] { assembled(mesh, iterations); }}},
          runs);
  const std::vector<Mesh::Vertex_index> sources = spread_sources(mesh, NUMBER_OF_LANDMARKS);
  compare({{"Heat_geodesics_3", [&] { CP::Heat_geodesics_3<Mesh>(mesh).distances(sources); }},
           {"CGAL's heat method, intrinsic Delaunay",
            [&] {
              fields_of_cgal(mesh, [&](const CP::Landmark_fields_3& fields) {
                return sources[fields.landmarks.size()];
              });
            }},
           {"libigl's heat method, intrinsic Delaunay", [&] { heat_of_libigl(mesh, sources); }}},
          runs);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto vertices = std::size_t(arguments.take_number("--vertices", 50000));
    const auto runs = (std::max)(std::size_t(1), std::size_t(arguments.take_number("--runs", 3)));
    std::printf("%s\nmedians of %zu runs, and ratios to the first\n", setting().c_str(), runs);
    for(const std::string& file : arguments.rest())
    {
      Mesh mesh;
      if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh))
        throw std::runtime_error("cannot read " + file);
      compare(file.substr(file.find_last_of('/') + 1), mesh, runs);
    }
    compare(
      "figure, sitting",
      Articulated_figure(vertices).make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles),
      runs);
  }
  catch(const std::exception& e)
  {
    std::cerr << "peers_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
