// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test_coarse_meshes {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using Soup = shapes::Triangle_soup;

// The prism over a polygon that is triangulated by triples of its corners.
Soup prism(const std::vector<std::array<double, 2>>& corners,
           const std::vector<std::array<std::size_t, 3>>& triangles, const double height)
{
  Soup soup;
  const std::size_t n = corners.size();
  for(const double z : {0., height})
    for(const auto& [x, y] : corners)
      soup.points.push_back({x, y, z});
  for(const auto& [a, b, c] : triangles)
  {
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({a + n, b + n, c + n});
  }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    soup.triangles.push_back({i, j, j + n});
    soup.triangles.push_back({i, j + n, i + n});
  }
  return soup;
}

Soup box(const double x, const double y, const double z)
{
  return prism({{0, 0}, {x, 0}, {x, y}, {0, y}}, {{0, 1, 2}, {0, 2, 3}}, z);
}

Soup l_prism()
{
  return prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}},
               {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}, 1);
}

Soup u_prism()
{
  return prism({{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 3}, {0, 3}},
               {{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}}, 1);
}

// The prism over a regular polygon that is triangulated by diagonals from one corner.
Soup regular_prism(const std::size_t n, const double height)
{
  std::vector<std::array<double, 2>> corners;
  std::vector<std::array<std::size_t, 3>> triangles;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * shapes::pi * double(i) / double(n);
    corners.push_back({std::cos(angle), std::sin(angle)});
    if(i >= 2)
      triangles.push_back({0, i - 1, i});
  }
  return prism(corners, triangles, height);
}

Soup ellipsoid(const unsigned int subdivisions)
{
  Soup soup = shapes::icosphere_soup(subdivisions, 1);
  for(auto& p : soup.points)
    p = {3 * p[0], 2 * p[1], p[2]};
  return soup;
}

// The same shape: each triangle becomes four. The vertices remain the first ones.
Soup subdivided(const Soup& soup)
{
  Soup result;
  result.points = soup.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](const std::size_t a, const std::size_t b) {
    const auto found
      = middles.emplace(std::make_pair((std::min)(a, b), (std::max)(a, b)), result.points.size());
    if(found.second)
    {
      const auto &p = soup.points[a], &q = soup.points[b];
      result.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
    }
    return found.first->second;
  };
  for(const auto& [a, b, c] : soup.triangles)
  {
    const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for(const std::array<std::size_t, 3>& t :
        {std::array<std::size_t, 3>{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      result.triangles.push_back(t);
  }
  return result;
}

// At the vertices in common.
double difference(const Point_matrix& pose, const Point_matrix& other)
{
  const Eigen::Index n = (std::min)(pose.rows(), other.rows());
  return CP::pose_difference(pose.topRows(n), other.topRows(n));
}

Point_matrix pose(const Soup& soup, const CP::Options& options = CP::Options())
{
  return shapes::pose_of(soup, options).pose;
}

// Compares the pose with that of the first subdivision with so many vertices.
void expect_pose_of_subdivision(Soup soup, const std::size_t number)
{
  const Point_matrix coarse = pose(soup);
  const std::size_t n = soup.points.size();
  ASSERT_LT(n, 500u);
  while(soup.points.size() < number)
    soup = subdivided(soup);
  EXPECT_LT(difference(coarse, pose(soup)), .03) << n << " vertices";
}

CP::Result pose_of(const shapes::Tetrahedral_soup& soup)
{
  CP::Indexed_tetrahedra_3<CGAL::Simple_cartesian<double>::Point_3> complex;
  for(const auto& p : soup.points)
    complex.points.emplace_back(p[0], p[1], p[2]);
  complex.cells = soup.cells;
  std::vector<CGAL::Simple_cartesian<double>::Point_3> pose(soup.points.size());
  return CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose));
}

// Poses do not depend on the triangles of a shape: subdivided until there are 2000 vertices, with which
// distances were always measured well, it has the same pose. The differences were up to 0.40.
TEST(Coarse_meshes, pose_of_a_subdivision)
{
  for(const Soup& soup : {box(3, 2, 1), box(10, 1, 1), box(4, 3, .3), l_prism(), u_prism(),
                          shapes::tube_soup(6, 8, 6, 1), shapes::torus_soup(20, 10, 2, .6),
                          ellipsoid(1), ellipsoid(2),
                          shapes::boundary(shapes::tetrahedral_bent_bar(24, 3, 3, 2.))})
    expect_pose_of_subdivision(soup, 2000);
}

// Their faces require more vertices. Landmarks are spread evenly over the refined surface, although the
// vertices of the input are not: with landmarks among the latter, the differences of the last two were
// .037 and .034.
TEST(Coarse_meshes, pose_of_a_subdivision_of_long_faces)
{
  const Soup tetrahedron{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}},
                         {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  for(const Soup& soup : {box(1, 1, 1), box(1, 1, 3), box(1, 1, 30),
                          tetrahedron, regular_prism(12, 1), regular_prism(100, 1),
                          regular_prism(120, 1), subdivided(regular_prism(50, 1))})
    expect_pose_of_subdivision(soup, 5000);
}

// Distances on a convex polygon are those of the plane, so its target is the polygon itself.
TEST(Coarse_meshes, planar_meshes_keep_their_shape)
{
  const Soup diamond{{{0, 0, 0}, {1, -3, 0}, {2, 0, 0}, {1, 3, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const Soup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  for(Soup soup : {diamond, triangle, shapes::plane_grid_soup(2, 3, 1., 3.)})
  {
    for(auto& p : soup.points)
      p[2] = .5 * p[0] + .25 * p[1];
    for(int level = 0; level < 5; level += 2, soup = subdivided(subdivided(soup)))
      EXPECT_LT(difference(pose(soup), shapes::to_matrix(soup.points)), 1e-3)
        << soup.points.size() << " vertices";
  }
}

// Where a plane is not convex, distances within it have less stress in space: poses left the plane by
// 5 % of the diameter. Distances of the caller may be those of a curved surface.
TEST(Coarse_meshes, planar_meshes_remain_planar)
{
  for(const Soup& solid : {l_prism(), u_prism()})
  {
    Soup soup = solid;
    const std::size_t n = soup.points.size() / 2;
    soup.points.resize(n);
    soup.triangles.clear();
    for(const auto& t : solid.triangles)
      if(*std::max_element(t.begin(), t.end()) < n)
        soup.triangles.push_back(t);
    for(auto& p : soup.points)
      p[2] = .5 * p[0] + .25 * p[1];
    const auto height = [](const Point_matrix& points) {
      const CP::internal::Principal_axes frame(points, Eigen::VectorXd::Ones(points.rows()));
      return std::sqrt(std::abs(frame.variances[2]) / frame.variances[0]);
    };
    for(int level = 0; level < 2; ++level, soup = subdivided(soup))
    {
      CP::Options options;
      options.return_landmark_fields = true;
      const CP::Result result = shapes::pose_of(soup, options);
      EXPECT_LT(height(result.pose), 1e-6) << soup.points.size() << " vertices";
      options.given.landmark_fields = result.landmark_fields;
      EXPECT_LT(height(pose(soup, options)), 1e-6) << soup.points.size() << " vertices";
      const Point_matrix points = shapes::to_matrix(soup.points);
      Point_matrix curved = points;
      curved.col(0) = points.col(0).array().sin();
      curved.col(2) = points.col(0).array().cos();
      CP::Landmark_fields_3& fields = *options.given.landmark_fields;
      for(std::size_t j = 0; j < fields.landmarks.size(); ++j)
        fields.distances.col(Eigen::Index(j))
          = (curved.rowwise() - curved.row(Eigen::Index(fields.landmarks[j]))).rowwise().norm();
      options.number_of_rounds = 0;
      EXPECT_GT(height(pose(soup, options)), .1) << soup.points.size() << " vertices";
    }
  }
}

// Across a needle, distances do not determine coordinates: rounding errors took the place of its
// height, and it was shortened to a tenth.
TEST(Coarse_meshes, needles_keep_their_shape)
{
  for(const double height : {1e-4, 1e-5, 1e-6, 1e-8})
  {
    const Soup needle{{{0, 0, 0}, {1, 0, 0}, {.3, height, 0}}, {{0, 1, 2}}};
    EXPECT_LT(difference(pose(needle), shapes::to_matrix(needle.points)), 1e-3) << height;
  }
}

// All triangles are pieces of those of the input, and as many vertices as a mesh of some thousand are
// added, even to a fan of thin triangles.
TEST(Coarse_meshes, refined_surface)
{
  Soup fan;
  fan.points.push_back({0, 0, 0});
  constexpr std::size_t n = 300;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * 3.141592653589793 * double(i) / n;
    fan.points.push_back({std::cos(angle), std::sin(angle), .3 * std::cos(2 * angle)});
    fan.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  for(const Soup& soup : {box(3, 2, 1), l_prism(), fan})
  {
    const Point_matrix points = shapes::to_matrix(soup.points);
    const CP::Prepared_surface_3 prepared = CP::prepare_surface(
      points, std::vector<std::vector<std::size_t>>(shapes::to_polygons(soup).polygons));
    ASSERT_EQ(prepared.components.size(), 1u);
    const CP::Surface_component_3& surface = prepared.components.front().surface;
    EXPECT_EQ(surface.origins.size(), soup.points.size());
    EXPECT_EQ(surface.points.topRows(points.rows()), points);
    EXPECT_EQ(surface.added.size() + surface.origins.size(), std::size_t(surface.points.rows()));
    EXPECT_GT(surface.points.rows(), 1000);
    EXPECT_LE(surface.points.rows(), 5000);
    for(const auto& [vertex, others, weights] : surface.added)
    {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for(std::size_t k = 0; k < 3; ++k)
        sum += weights[k] * surface.points.row(Eigen::Index(others[k]));
      EXPECT_EQ(sum, surface.points.row(Eigen::Index(vertex)));
    }
    Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero(); // of the boundary loop with its cap: 0
    std::vector<double> area_of_face(soup.triangles.size(), 0);
    const auto area = [](const Point_matrix& p, const std::array<std::size_t, 3>& t) {
      const Eigen::Vector3d a = p.row(Eigen::Index(t[0])), b = p.row(Eigen::Index(t[1])),
                            c = p.row(Eigen::Index(t[2]));
      return Eigen::Vector3d((b - a).cross(c - a) / 2);
    };
    for(const auto* const triangles : {&surface.triangles, &surface.caps})
      for(const auto& t : *triangles)
        normal_sum += area(surface.points, t);
    EXPECT_LT(normal_sum.norm(), 1e-12);
    for(std::size_t t = 0; t < surface.triangles.size(); ++t)
      area_of_face[surface.face_of_triangle[t]]
        += area(surface.points, surface.triangles[t]).norm();
    for(std::size_t t = 0; t < soup.triangles.size(); ++t)
      EXPECT_NEAR(area_of_face[t], area(points, soup.triangles[t]).norm(), 1e-12);
  }
}

// What refers to vertices of the input still does: a handle holds its vertex, values of the vertices
// are interpolated, and landmarks are vertices of the input.
TEST(Coarse_meshes, options_of_vertices)
{
  const Soup soup = l_prism();
  const Point_matrix points = shapes::to_matrix(soup.points), free = pose(soup);
  CP::Options options;
  const Eigen::RowVector3d position = free.row(2) + Eigen::RowVector3d(0, 1, 0);
  options.constraints.handles.push_back({2, position, 1e4});
  EXPECT_LT((pose(soup, options).row(2) - position).norm(), .05);

  options = CP::Options();
  options.matching_weights = Eigen::VectorXd::Constant(points.rows(), 2.);
  options.stiffness = Eigen::VectorXd::Ones(points.rows());
  EXPECT_LT(difference(pose(soup, options), free), 1e-6);

  options = CP::Options();
  options.return_landmark_fields = true;
  const CP::Result result = shapes::pose_of(soup, options);
  ASSERT_TRUE(result.landmark_fields);
  EXPECT_EQ(result.pose, free);
  EXPECT_EQ(result.landmark_fields->landmarks.size(), soup.points.size());
  EXPECT_EQ(result.landmark_fields->distances.rows(), points.rows());
  const Eigen::MatrixXd exact
    = CP::geodesic_distances(points, shapes::to_polygons(soup).polygons,
                             result.landmark_fields->landmarks); // wavefronts, up to 1e-3
  EXPECT_LT((result.landmark_fields->distances - exact).cwiseAbs().mean(), .05 * exact.mean());
  options = CP::Options();
  options.given = result;
  EXPECT_LT(difference(pose(soup, options), free), .05);

  options = CP::Options();
  options.frame = CP::Options::Frame::CANONICAL;
  EXPECT_LT(difference(pose(soup, options), free), 1e-6);
  options = CP::Options();
  options.given.target = points;
  EXPECT_LT(difference(pose(soup, options), points), 1e-6);
}

// The boundary of a complex is refined, too, so distances on twelve cells are those on many.
TEST(Coarse_meshes, complex)
{
  const shapes::Tetrahedral_soup coarse = shapes::tetrahedral_box(2, 1, 1, {{6., 1., 1.}});
  const shapes::Tetrahedral_soup fine = shapes::tetrahedral_box(24, 4, 4, {{6., 1., 1.}});
  const CP::Result result = pose_of(coarse), of_fine = pose_of(fine);
  EXPECT_EQ(result.pose.rows(), Eigen::Index(coarse.points.size()));
  EXPECT_NEAR(result.summary.target.max_geodesic / of_fine.summary.target.max_geodesic, 1, .03);
}

} // namespace test_coarse_meshes
