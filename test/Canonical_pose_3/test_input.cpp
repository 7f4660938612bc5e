// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include "dirty_shapes.h"
#include "matchers.h"
#include "shapes.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace test_input {

namespace CP = CGAL::Canonical_pose_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

const Kernel::Point_3 untouched(7, 7, 7);

Mesh unit_bar() { return Canonical_pose_test::bar<Mesh>(6, 2, 2); }

// The call must throw with the text, and not modify the map of the pose.
template <class Exception = std::invalid_argument>
void expect_refused(const Mesh& mesh, const std::string& text,
                    const CP::Options& options = CP::Options())
{
  std::vector<Kernel::Point_3> pose(mesh.num_vertices(), untouched);
  EXPECT_THROW_WITH(
    CGAL::canonical_pose_3(
      mesh, boost::make_iterator_property_map(pose.begin(), get(boost::vertex_index, mesh)),
      options),
    Exception, text);
  for(const Kernel::Point_3& p : pose)
    EXPECT_EQ(p, untouched);
}

CP::Options with_tetgen()
{
  CP::Options options;
  options.body = CP::Options::Body::TETGEN;
  return options;
}

TEST(Bad_input, surfaces_are_refused_by_name)
{
  expect_refused(Mesh(), "no face");

  Mesh line;
  CGAL::make_triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(3, 0, 0),
                      line);
  expect_refused(line, "all its faces are degenerate");

  Mesh mesh = unit_bar();
  mesh.point(Mesh::Vertex_index(5))
    = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_refused(mesh, "vertex 5 has a coordinate that is not finite");
  mesh.point(Mesh::Vertex_index(5))
    = Kernel::Point_3(0, 0, std::numeric_limits<double>::infinity());
  expect_refused(mesh, "vertex 5 has a coordinate that is not finite");

  Mesh two = unit_bar();
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 9), Kernel::Point_3(1, 0, 9),
                         Kernel::Point_3(0, 1, 9), Kernel::Point_3(0, 0, 10), two);
  expect_refused(two, "2 connected components");
}

// TetGen terminates the process on many defects.
TEST(Bad_input, tetgen_is_spared_surfaces_with_defects)
{
  Mesh one;
  CGAL::make_triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                      one);
  expect_refused(one, "not closed: 3 boundary edges", with_tetgen());

  Mesh holed = unit_bar();
  CGAL::Euler::remove_face(holed.halfedge(Mesh::Face_index(3)), holed);
  expect_refused(holed, "not closed: 3 boundary edges", with_tetgen());

  Mesh degenerate = unit_bar();
  const auto h = degenerate.halfedge(Mesh::Face_index(17));
  degenerate.point(degenerate.source(h)) = degenerate.point(degenerate.target(h));
  expect_refused(degenerate, "is degenerate", with_tetgen());

  Mesh isolated = unit_bar();
  isolated.add_vertex(Kernel::Point_3(1, 2, 3));
  expect_refused(isolated, "belongs to no face", with_tetgen());

  // a vertex moved through the other side
  Mesh crossing = unit_bar();
  double highest = -1;
  Mesh::Vertex_index top;
  for(const auto v : crossing.vertices())
    if(crossing.point(v).z() + 0.01 * crossing.point(v).x() > highest)
    {
      highest = crossing.point(v).z() + 0.01 * crossing.point(v).x();
      top = v;
    }
  crossing.point(top) = Kernel::Point_3(1.5, 0.4, -3);
  expect_refused(crossing, "intersects itself", with_tetgen());
}

TEST(Bad_input, options_are_refused_by_name)
{
  const Mesh mesh = unit_bar();
  CP::Options options;
  options.number_of_landmarks = 0;
  expect_refused(mesh, "number_of_landmarks", options);
  options = CP::Options();
  options.registration.detail_length = 0;
  expect_refused(mesh, "detail_length", options);
  options.registration.detail_length = std::numeric_limits<double>::quiet_NaN();
  expect_refused(mesh, "detail_length", options);
  options = CP::Options();
  options.registration.tikhonov = -1;
  expect_refused(mesh, "tikhonov", options);
  options = CP::Options();
  options.number_of_rounds = -1;
  expect_refused(mesh, "number_of_rounds", options);
  options = CP::Options();
  options.number_of_threads = -1;
  expect_refused(mesh, "number_of_threads", options);
  options = CP::Options();
  options.constraints.springs.push_back({0, 1000000, 1., 1.});
  expect_refused(mesh, "spring 0 names vertex 1000000", options);
}

// A degenerate face is repaired for exact distances, too. A cube of quads, followed by a flat triangle
// formed by the midpoint of an edge and its endpoints.
TEST(Bad_input, degenerate_faces_have_exact_distances)
{
  auto cube = Canonical_pose_test::quad_cube();
  cube.points.push_back({{0., 0., 0.5}});
  cube.polygons[4] = {0, 8, 4, 6, 2};
  cube.polygons.push_back({0, 4, 8});
  std::vector<Kernel::Point_3> points, pose;
  for(const auto& p : cube.points)
    points.emplace_back(p[0], p[1], p[2]);
  CP::Options options;
  options.number_of_landmarks = 4;
  options.number_of_rounds = 0;
  options.number_of_coarse_vertices = 300;
  options.landmark_fields_function = CP::landmark_fields_function<CP::Exact_geodesics_3<Mesh>>();
  const auto result = CGAL::canonical_pose_3(points, cube.polygons, pose, options);
  EXPECT_TRUE(result.is_usable());
  EXPECT_TRUE(result.pose.allFinite());
  EXPECT_NEAR(CGAL::midpoint(pose[0], pose[4]).z(), pose[8].z(), 0.05);
}

// Squares and cubes of lengths neither overflow nor vanish: extreme units are refused; in other
// units, powers of two only change the unit.
TEST(Bad_input, unit_of_length)
{
  const auto scaled = [](const double factor) {
    Mesh mesh = Canonical_pose_test::bent_bar<Mesh>(16, 2, 2, 2.);
    for(const auto v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + factor * (mesh.point(v) - CGAL::ORIGIN);
    return mesh;
  };
  expect_refused(scaled(1e160), "the largest coordinate is");
  expect_refused(scaled(1e-160), "choose another unit");
  Mesh plain = scaled(1);
  CGAL::canonical_pose_3(plain, plain.points());
  for(const int exponent : {-290, 290})
  {
    Mesh mesh = scaled(std::ldexp(1., exponent));
    CGAL::canonical_pose_3(mesh, mesh.points());
    for(const auto v : mesh.vertices())
      EXPECT_LT(std::sqrt(CGAL::squared_distance(
                  plain.point(v),
                  CGAL::ORIGIN + std::ldexp(1., -exponent) * (mesh.point(v) - CGAL::ORIGIN))),
                1e-9)
        << exponent;
  }
}

// A target so far away that squared distances overflow has no pose; the map is unchanged, nothing
// is NaN.
TEST(Bad_input, overflow_is_reported_by_the_summary)
{
  const Mesh mesh = unit_bar();
  CP::Options options;
  options.given.target = CP::point_matrix(mesh) * 1e200;
  std::vector<Kernel::Point_3> pose(mesh.num_vertices(), untouched);
  const auto result = CGAL::canonical_pose_3(
    mesh, boost::make_iterator_property_map(pose.begin(), get(boost::vertex_index, mesh)), options);
  EXPECT_EQ(result.summary.termination, CP::Registration_summary::NOT_FINITE);
  EXPECT_FALSE(result.is_usable());
  EXPECT_EQ(result.pose.rows(), 0);
  EXPECT_EQ(pose[0], untouched);
}

// Self-intersections do not change a pose: they are counted if this is requested, and for meshers, which refuse them.
TEST(Self_intersections, are_counted_on_request)
{
  const Canonical_pose_test::Polygon_soup soup
    = merged(Canonical_pose_test::ball(), Canonical_pose_test::ball(), .5);
  std::vector<Kernel::Point_3> points, pose;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  CP::Options options;
  options.components = CP::Options::Components::EACH;
  const CP::Result without = CGAL::canonical_pose_3(points, soup.polygons, pose, options);
  EXPECT_FALSE(without.summary.input.has_searched_self_intersections);
  EXPECT_FALSE(without.summary.input.self_intersections);
  options.searches_self_intersections = true;
  const CP::Result with = CGAL::canonical_pose_3(points, soup.polygons, pose, options);
  EXPECT_TRUE(with.summary.input.has_searched_self_intersections);
  EXPECT_GT(with.summary.input.self_intersections.value(), 0u);
  EXPECT_EQ(with.pose, without.pose);
}

} // namespace test_input
