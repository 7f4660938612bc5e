// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <limits>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Triangle_soup;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

const Kernel::Point_3 untouched(7, 7, 7);

Mesh unit_bar() { return Canonical_pose_test::bar<Mesh>(6, 2, 2); }

// The call must throw with the text, and leave the map of the pose as it was.
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

Triangle_soup merged(Triangle_soup a, const Triangle_soup& b, const double shift)
{
  const std::size_t n = a.points.size();
  for(auto p : b.points)
  {
    p[0] += shift;
    a.points.push_back(p);
  }
  for(auto t : b.triangles)
    a.triangles.push_back({{t[0] + n, t[1] + n, t[2] + n}});
  return a;
}

CP::Diagnosis_3 diagnosis(const Triangle_soup& soup)
{
  return CP::diagnose(Canonical_pose_test::to_matrix(soup.points), soup.triangles);
}

} // namespace

TEST(Bad_input, surfaces_are_refused_by_name)
{
  expect_refused(Mesh(), "no face");

  Mesh one;
  CGAL::make_triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                      one);
  expect_refused(one, "not closed: 3 boundary edges");

  Mesh mesh = unit_bar();
  mesh.point(Mesh::Vertex_index(5))
    = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_refused(mesh, "vertex 5 has a coordinate that is not finite");
  mesh.point(Mesh::Vertex_index(5))
    = Kernel::Point_3(0, 0, std::numeric_limits<double>::infinity());
  expect_refused(mesh, "vertex 5 has a coordinate that is not finite");

  mesh = unit_bar();
  const auto h = mesh.halfedge(Mesh::Face_index(17));
  mesh.point(mesh.source(h)) = mesh.point(mesh.target(h));
  expect_refused(mesh, "is degenerate");
}

TEST(Bad_input, surfaces_with_defects_between_faces)
{
  Mesh holed = unit_bar();
  CGAL::Euler::remove_face(holed.halfedge(Mesh::Face_index(3)), holed);
  expect_refused(holed, "not closed: 3 boundary edges");

  const auto sphere = Canonical_pose_test::icosphere_soup(1, 1.);
  expect_refused(Canonical_pose_test::to_mesh<Mesh>(merged(sphere, sphere, 5.)),
                 "2 connected components");

  // two vertices drawn through the other side
  Mesh crossing = Canonical_pose_test::bar<Mesh>(6, 2, 2);
  double highest = -1;
  Mesh::Vertex_index top;
  for(const auto v : crossing.vertices())
    if(crossing.point(v).z() + 0.01 * crossing.point(v).x() > highest)
    {
      highest = crossing.point(v).z() + 0.01 * crossing.point(v).x();
      top = v;
    }
  crossing.point(top) = Kernel::Point_3(1.5, 0.4, -3);
  expect_refused(crossing, "intersects itself");

  Mesh quads;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0),
                        Kernel::Point_3(1, 1, 0), Kernel::Point_3(0, 1, 0),
                        Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), quads);
  expect_refused(quads, "face 0 is not a triangle");

  Mesh isolated = unit_bar();
  isolated.add_vertex(Kernel::Point_3(1, 2, 3));
  expect_refused(isolated, "belongs to no face");
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
  options.number_of_threads = -1;
  expect_refused(mesh, "number_of_threads", options);
  options = CP::Options();
  options.springs.push_back({0, 1000000, 1., 1.});
  expect_refused(mesh, "spring 0 names vertex 1000000", options);
}

// Each count is known by construction.
TEST(Diagnosis, counts)
{
  const auto sphere = Canonical_pose_test::icosphere_soup(1, 1.);
  EXPECT_TRUE(diagnosis(sphere).is_clean());
  EXPECT_EQ(*diagnosis(sphere).self_intersections, 0u);

  Triangle_soup soup = merged(sphere, sphere, 5.);
  soup.points.push_back({{9., 9., 9.}});
  CP::Diagnosis_3 found = diagnosis(soup);
  EXPECT_EQ(found.components, 2u);
  EXPECT_EQ(found.isolated_vertices, 1u);
  EXPECT_EQ(found.vertices, 2 * 42u + 1);
  EXPECT_EQ(found.faces, 2 * 80u);

  soup = sphere;
  soup.triangles.pop_back();
  EXPECT_EQ(diagnosis(soup).boundary_edges, 3u);
  soup.triangles.push_back(sphere.triangles.back());
  soup.triangles.push_back({{sphere.triangles[0][0], sphere.triangles[0][1], 40}}); // a fin
  EXPECT_EQ(diagnosis(soup).non_manifold_edges, 1u);
  EXPECT_FALSE(diagnosis(soup).self_intersections);

  soup = sphere;
  std::swap(soup.triangles[4][0], soup.triangles[4][1]);
  EXPECT_EQ(diagnosis(soup).non_manifold_edges, 3u);

  soup = merged(sphere, sphere, 5.); // glued at one vertex
  for(auto& t : soup.triangles)
    for(auto& v : t)
      if(v == 42)
        v = 0;
  EXPECT_EQ(diagnosis(soup).non_manifold_vertices, 1u);
  EXPECT_EQ(diagnosis(soup).components, 1u);

  soup = merged(sphere, sphere, 0.5);
  EXPECT_GT(*diagnosis(soup).self_intersections, 0u);

  soup = sphere;
  soup.triangles[7][1] = soup.triangles[7][0];
  EXPECT_EQ(diagnosis(soup).degenerate_faces, 1u);
  soup.triangles[7][1] = 42;
  EXPECT_THROW_WITH(diagnosis(soup), std::invalid_argument,
                    "face 7 names vertex 42, but there are 42");
}

// A target so far away that squared distances overflow has no pose; the map stays as it was,
// nothing is NaN.
TEST(Bad_input, overflow_is_reported_by_the_summary)
{
  const Mesh mesh = unit_bar();
  CP::Intermediate_results results;
  results.target = CP::point_matrix(mesh) * 1e200;
  CP::Options options;
  options.intermediate_results = &results;
  std::vector<Kernel::Point_3> pose(mesh.num_vertices(), untouched);
  const auto summary = CGAL::canonical_pose_3(
    mesh, boost::make_iterator_property_map(pose.begin(), get(boost::vertex_index, mesh)), options);
  EXPECT_EQ(summary.termination, CP::Registration_summary::NOT_FINITE);
  EXPECT_FALSE(summary.is_usable());
  EXPECT_EQ(pose[0], untouched);
}
