// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every function that takes indices, labels or distances from a user refuses bad ones, and names the
// element. The largest number is what -1 becomes.

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Retrieval_evaluation.h>
#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/segmentation_parts.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>
#include <CGAL/Canonical_pose_3/triangulate_polygons.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_bad_indices {

namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

using Triangles = std::vector<std::array<std::size_t, 3>>;

const std::size_t MINUS_ONE = std::size_t(-1);
const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN(),
             INFINITE = std::numeric_limits<double>::infinity();

// A tetrahedron.
const Triangles TRIANGLES = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

Point_matrix corners()
{
  Point_matrix points = Point_matrix::Zero(4, 3);
  points.bottomRows(3).setIdentity();
  return points;
}

CP::Conforming_body_3 tetrahedron() { return CP::Conforming_body_3(corners(), {{0, 1, 2, 3}}, 4); }

// Distances of points on a line.
Eigen::MatrixXd distances_on_a_line(const Eigen::Index n)
{
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1));
  return (x.replicate(1, n) - x.transpose().replicate(n, 1)).cwiseAbs();
}

TEST(Bad_indices, of_triangles)
{
  const Point_matrix points = corners();
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(4, .25);
  const CP::Conforming_body_3 body = tetrahedron();
  const Eigen::MatrixXd distances = Eigen::MatrixXd::Ones(4, 1);
  using Function = std::function<void(const Triangles&)>;
  for(const Function& f : std::vector<Function>{
        [&](const Triangles& t) { CP::vertex_area_shares(points, t); },
        [&](const Triangles& t) { CP::median_edge_strain(points, points, t); },
        [&](const Triangles& t) { CP::vertex_strains(points, points, t); },
        [&](const Triangles& t) { CP::vertex_normals(points, t); },
        [&](const Triangles& t) { CP::extremal_point(points, t); },
        [&](const Triangles& t) { CP::target_handedness(points, points, t, weights); },
        [&](const Triangles& t) { CP::make_triangle_mesh<Mesh>(points, t); },
        [&](const Triangles& t) { CP::Body_deformer_3<CP::Conforming_body_3>(body, t); },
        [&](const Triangles& t) { CP::Lattice_body_3(points, t, distances); }})
    for(const std::size_t bad : {std::size_t(4), MINUS_ONE})
    {
      Triangles triangles = TRIANGLES;
      triangles[2][1] = bad;
      EXPECT_THROW_WITH(f(triangles), std::invalid_argument,
                        "triangle 2 names vertex " + std::to_string(bad) + ", but there are 4");
    }
  EXPECT_THROW_WITH(CP::Lattice_body_3(points, TRIANGLES, distances, 0, {{{0, 1, 4}}}),
                    std::invalid_argument, "cap 0 names vertex 4");
  EXPECT_THROW_WITH(
    CP::vertex_strains(points, points, std::vector<std::array<std::size_t, 4>>{{{0, 1, 2, 4}}}),
    std::invalid_argument, "tetrahedron 0 names vertex 4");
}

TEST(Bad_indices, of_polygons)
{
  const Point_matrix points = corners();
  using Polygons = std::vector<std::vector<std::size_t>>;
  using Function = std::function<void(const Polygons&)>;
  for(const Function& f :
      std::vector<Function>{[&](const Polygons& p) { CP::triangulate_polygons(points, p); },
                            [&](const Polygons& p) { CP::repair_surface(points, p); },
                            [&](const Polygons& p) {
                              CP::segmentation_parts(points, p, {0, 1});
                            }})
    for(const std::size_t bad : {std::size_t(4), MINUS_ONE})
      EXPECT_THROW_WITH(f({{0, 1, 2}, {0, 1, bad, 3}}), std::invalid_argument,
                        "face 1 names vertex " + std::to_string(bad) + ", but "
                          + (bad == 4 ? "there are 4" : "indices are less than 4294967296"));
}

// With a coordinate that is not finite, or so large that areas overflow, no triangulation of a quad has
// a finite cost.
TEST(Bad_coordinates, of_quads)
{
  for(const double bad : {NOT_A_NUMBER, INFINITE, 1e160, 1e300})
  {
    Point_matrix points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    if(std::isfinite(bad))
      points *= bad;
    else
      points(2, 1) = bad;
    const std::vector<std::vector<std::size_t>> quad = {{0, 1, 2, 3}};
    if(std::isfinite(bad))
    {
      EXPECT_EQ(CP::triangulate_polygons(points, quad).triangles.size(), 2u);
      EXPECT_EQ(CP::repair_surface(points, quad).triangles.size(), 2u);
      EXPECT_THROW_WITH(CP::segmentation_parts(points, quad, {0}), std::invalid_argument,
                        "choose another unit");
      continue;
    }
    EXPECT_THROW_WITH(CP::triangulate_polygons(points, quad), std::invalid_argument, "vertex 2");
    EXPECT_THROW_WITH(CP::repair_surface(points, quad), std::invalid_argument, "vertex 2");
    EXPECT_THROW_WITH(CP::segmentation_parts(points, quad, {0}), std::invalid_argument, "vertex 2");
  }
}

// The triangulation itself ends, whatever the points are, with n - 2 triangles of n corners.
TEST(Bad_coordinates, of_loops)
{
  for(const Eigen::Index n : {4, 5, 64, 65, 200})
    for(const double bad : {NOT_A_NUMBER, INFINITE, 1e160})
    {
      std::vector<std::size_t> loop;
      for(Eigen::Index i = 0; i < n; ++i)
        loop.push_back(static_cast<std::size_t>(i));
      Triangles triangles;
      CP::internal::Loop_triangulation(bad * Point_matrix::Random(n, 3), loop).run(triangles);
      EXPECT_EQ(triangles.size(), static_cast<std::size_t>(n) - 2);
    }
}

TEST(Bad_indices, of_parts)
{
  const Point_matrix points = corners();
  const std::vector<std::vector<std::size_t>> faces = {{0, 2, 1}, {0, 1, 3}};
  EXPECT_EQ(CP::segmentation_parts(points, faces, {0, 1}).size(), 2u);
  EXPECT_THROW_WITH(CP::segmentation_parts(points, faces, {0, MINUS_ONE}), std::invalid_argument,
                    "face 1 is in part 18446744073709551615");
  EXPECT_THROW_WITH(CP::segmentation_parts(points, faces, {0, 2}), std::invalid_argument,
                    "face 1 is in part 2");
  EXPECT_THROW_WITH(CP::segmentation_parts(points, faces, {0}), std::invalid_argument,
                    "1 parts of polygons, but 2 polygons");
  Mesh mesh = CP::make_triangle_mesh<Mesh>(points, TRIANGLES);
  const auto ids = mesh.add_property_map<Mesh::Face_index, int>("f:part", 0).first;
  ids[Mesh::Face_index(3)] = -1;
  EXPECT_THROW_WITH(CP::segmentation_parts(mesh, ids), std::invalid_argument, "face 3 is in part ");

  CP::Segmentation_tree_3 tree;
  tree.number_of_leaves = 2;
  tree.leaf_of_face = {0, 1, 1};
  tree.merges = {{{{0, 1}}, .5}};
  EXPECT_EQ(tree.parts(1), (std::vector<std::size_t>{0, 0, 0}));
  for(const std::size_t bad : {std::size_t(2), MINUS_ONE})
  {
    CP::Segmentation_tree_3 changed = tree;
    changed.leaf_of_face[1] = bad;
    EXPECT_THROW_WITH(changed.parts(1), std::invalid_argument,
                      "face 1 is in leaf " + std::to_string(bad));
    changed = tree;
    changed.merges[0].nodes[1] = bad;
    EXPECT_THROW_WITH(changed.parts(1), std::invalid_argument,
                      "merge 0 names node " + std::to_string(bad));
  }
  tree.merges.resize(3, tree.merges.front());
  EXPECT_THROW_WITH(tree.parts(1), std::invalid_argument, "3 merges of 2 leaves");
}

TEST(Bad_indices, of_landmarks)
{
  CP::Surface_component_3 surface;
  surface.points = corners();
  surface.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  surface.face_of_triangle = surface.origins = surface.body_origins = {0, 1, 2, 3};
  const CP::Landmark_fields_function exact
    = CP::landmark_fields_function<CP::Exact_geodesics_3<Mesh>>();
  for(const std::size_t bad : {std::size_t(4), MINUS_ONE})
  {
    const std::string number = std::to_string(bad);
    EXPECT_THROW_WITH(CP::landmark_fields(surface, {0, bad}), std::invalid_argument,
                      "landmark " + number + ", but there are 4 vertices");
    EXPECT_THROW_WITH(CP::coarse_surface(surface, 3, {bad}), std::invalid_argument,
                      "vertex " + number + " is to be kept, but there are 4");
    EXPECT_THROW_WITH(exact(surface.points, surface.triangles, 2, bad, {}), std::invalid_argument,
                      "landmark " + number);
    EXPECT_THROW_WITH(exact(surface.points, surface.triangles, 2, 0, {0, bad}),
                      std::invalid_argument, "landmark " + number);
  }
  CP::Component_options options;
  options.given.landmark_fields.emplace().landmarks = {0, 4};
  options.given.landmark_fields->distances = Eigen::MatrixXd::Ones(4, 2);
  CP::Coarse_surface_3 coarse = CP::coarse_surface(surface);
  EXPECT_THROW_WITH(CP::landmark_fields(coarse, options), std::invalid_argument,
                    "the given distances have landmark 4, but there are 4 vertices");
  options.given.landmark_fields->landmarks = {0, 1};
  options.given.landmark_fields->distances = Eigen::MatrixXd::Ones(3, 2);
  EXPECT_THROW_WITH(CP::landmark_fields(coarse, options), std::invalid_argument,
                    "the given distances have 3 rows, but there are 4 vertices");
  EXPECT_THROW_WITH(CP::component_of_surface(CP::Repaired_surface_3(), MINUS_ONE),
                    std::invalid_argument, "there is no component");
}

TEST(Bad_indices, of_bodies)
{
  for(const std::size_t bad : {std::size_t(5), MINUS_ONE})
    EXPECT_THROW_WITH(CP::Conforming_body_3(corners(), {{0, 1, 2, 3}}, bad), std::invalid_argument,
                      std::to_string(bad) + " surface vertices, but only 4 body vertices");
}

// All but the number of neighbors is the same as for n - 1 of them.
TEST(Distances_of_pairs, any_number_of_neighbors)
{
  const Eigen::MatrixXd distances = distances_on_a_line(6);
  for(const std::size_t number : {MINUS_ONE, MINUS_ONE / 2 + 1, std::size_t(6)})
    EXPECT_EQ(CP::manifold_ranking(distances, number), CP::manifold_ranking(distances, 5));
  EXPECT_EQ(CP::manifold_ranking(Eigen::MatrixXd(0, 0)).size(), 0);
  EXPECT_EQ(CP::manifold_ranking(Eigen::MatrixXd::Zero(1, 1), MINUS_ONE).size(), 1);
}

TEST(Distances_of_pairs, bad_ones_are_named)
{
  for(const double bad : {NOT_A_NUMBER, INFINITE, -1.})
  {
    Eigen::MatrixXd distances = distances_on_a_line(30);
    distances(4, 7) = bad;
    EXPECT_THROW_WITH(CP::manifold_ranking(distances), std::invalid_argument,
                      "entry (4, 7) of the matrix of distances");
    EXPECT_THROW_WITH(CP::fused_distances({distances_on_a_line(30), distances}),
                      std::invalid_argument, "entry (4, 7) of matrix 1 of distances");
    if(std::isnan(bad))
      EXPECT_THROW_WITH(CP::Retrieval_evaluation(distances, std::vector<std::size_t>(30, 0)),
                        std::invalid_argument, "that of shape 7 from query 4");
  }
}

TEST(Bad_weights, of_the_canonical_frame)
{
  for(const double bad : {NOT_A_NUMBER, INFINITE, -.1})
  {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(4);
    weights[2] = bad;
    EXPECT_THROW_WITH(CP::canonical_frame(corners(), weights), std::invalid_argument,
                      "weight 2 is");
  }
}

} // namespace test_bad_indices
