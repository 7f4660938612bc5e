// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_geodesic_distances {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using Polygons = std::vector<std::vector<std::size_t>>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::MatrixXd exact(const Point_matrix& points, const Triangles& triangles,
                      const std::vector<std::size_t>& sources)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  const Mesh mesh = CP::make_triangle_mesh<Mesh>(points, triangles);
  std::vector<Mesh::Vertex_index> vertices;
  for(const std::size_t source : sources)
    vertices.emplace_back(static_cast<Mesh::size_type>(source));
  return CP::Exact_geodesics_3<Mesh>(mesh).distances(vertices);
}

// By heat, wavefront and exact geodesics.
std::vector<Eigen::MatrixXd> distances(const std::vector<std::array<double, 3>>& points,
                                       const Polygons& polygons,
                                       const std::vector<std::size_t>& sources)
{
  const Point_matrix matrix = shapes::to_matrix(points);
  CP::Options wavefront;
  wavefront.geodesics = CP::Options::Geodesics::WAVEFRONT;
  return {CP::geodesic_distances(matrix, polygons, sources),
          CP::geodesic_distances(matrix, polygons, sources, wavefront),
          CP::geodesic_distances(matrix, polygons, sources, {}, exact)};
}

void expect_distances(const std::vector<std::array<double, 3>>& points, const Polygons& polygons,
                      const std::size_t source, const std::vector<double>& expected,
                      const double tolerance = 1e-6)
{
  for(const Eigen::MatrixXd& d : distances(points, polygons, {source}))
    for(std::size_t v = 0; v < expected.size(); ++v)
      if(expected[v] == infinity)
        EXPECT_EQ(d(Eigen::Index(v), 0), infinity) << v;
      else
        EXPECT_NEAR(d(Eigen::Index(v), 0), expected[v], tolerance) << v;
}

// The faces are the halves of squares with a common side, so distances are those of a plane, through
// the corner in common.
TEST(Geodesic_distances, edge_of_three_faces)
{
  expect_distances({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                   {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, 2, {1, std::sqrt(2.), 0, 2, 2});
}

// Three rectangles meet at an edge; from a corner of one to the opposite corner of another, the path
// crosses the edge in the middle; to points beside it at 1/64 of the edge at most, which makes it longer
// by less than 1e-3.
TEST(Geodesic_distances, path_over_an_edge_of_three_faces)
{
  expect_distances(
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, -1, 0}, {1, -1, 0}, {0, 0, 1}, {1, 0, 1}},
    {{0, 1, 3, 2}, {0, 1, 5, 4}, {0, 1, 7, 6}}, 2,
    {1, std::sqrt(2.), 0, 1, 2, std::sqrt(5.), 2, std::sqrt(5.)}, 1e-3);
}

// Two triangles with a vertex in common, then one more: along a line.
TEST(Geodesic_distances, vertices_of_several_fans)
{
  expect_distances({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {2, 0, 0}, {3, 1, 0}, {3, -1, 0}, {4, 0, 0}},
                   {{0, 2, 1}, {1, 2, 3}, {3, 5, 4}, {4, 5, 6}}, 0,
                   {0, std::sqrt(2.), std::sqrt(2.), 2, 2 + std::sqrt(2.), 2 + std::sqrt(2.), 4});
}

TEST(Geodesic_distances, vertex_without_faces)
{
  const std::vector<std::array<double, 3>> points
    = {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  const Polygons polygons = {{0, 2, 3}, {4, 5, 6}};
  expect_distances(points, polygons, 0, {0, infinity, 1, 1, infinity, infinity, infinity});
  EXPECT_THROW_WITH(CP::geodesic_distances(shapes::to_matrix(points), polygons, {0, 1}),
                    std::invalid_argument, "a source names vertex 1, which belongs to no face");
}

// A face without area, with three points on a line; and one with two points at the same position.
TEST(Geodesic_distances, faces_without_area)
{
  expect_distances({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {.5, 0, 0}, {.5, -1, 0}},
                   {{0, 4, 2}, {4, 3, 2}, {4, 1, 3}, {0, 1, 4}, {0, 5, 1}}, 2,
                   {1, std::sqrt(2.), 0, 1, std::sqrt(1.25), std::sqrt(4.25)}, 1e-5);
  expect_distances({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 0}, {2, 0, 0}},
                   {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {1, 5, 4}}, 2,
                   {1, std::sqrt(2.), 0, 1, 1, std::sqrt(5.)});
}

// The heat method is not accurate on a cube of twelve triangles; the corner opposite to the source is
// at the diagonal of two of its faces, unfolded.
// Across a face without area that shares an edge with a box, distances are those along the edge.
TEST(Geodesic_distances, face_without_area_beside_a_box)
{
  const std::vector<std::array<double, 3>> points
    = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1},
       {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {.5, 0, 0}};
  expect_distances(
    points,
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 8, 1}},
    0, {0, 1, 1, std::sqrt(2.), 1, std::sqrt(2.), std::sqrt(2.), std::sqrt(5.), .5});
}

TEST(Geodesic_distances, cube)
{
  expect_distances(
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, 0,
    {0, 1, 1, std::sqrt(2.), 1, std::sqrt(2.), std::sqrt(2.), std::sqrt(5.)});
}

// A fin of fine triangles on a sheet has more vertices in common with it than paths may cross at: all
// of it is reached, at most by paths along edges.
TEST(Geodesic_distances, many_vertices_in_common)
{
  constexpr std::size_t n = 100;
  std::vector<std::array<double, 3>> points;
  for(const std::array<double, 2> yz : {std::array<double, 2>{0, 0}, {1, 0}, {-1, 0}, {0, 1}})
    for(std::size_t i = 0; i <= n; ++i)
      points.push_back({double(i) / 10, yz[0], yz[1]});
  Polygons polygons;
  for(std::size_t k = 1; k <= 3; ++k)
    for(std::size_t i = 0; i < n; ++i)
      polygons.push_back({i, i + 1, k * (n + 1) + i + 1, k * (n + 1) + i});
  const std::vector<Eigen::MatrixXd> all = distances(points, polygons, {n + 1});
  for(std::size_t method = 1; method < all.size(); ++method)
    for(std::size_t v = 0; v < points.size(); ++v)
    {
      const auto& p = points[v];
      const double across = std::abs(p[1] - 1) + p[2]; // in the plane of both sheets, unfolded
      const double distance = all[method](Eigen::Index(v), 0);
      EXPECT_GE(distance, (1 - 1e-6) * std::hypot(p[0], across));
      EXPECT_LE(distance, (1 + .01) * std::hypot(p[0], across));
    }
  EXPECT_TRUE(all.front().allFinite());
}

} // namespace test_geodesic_distances
