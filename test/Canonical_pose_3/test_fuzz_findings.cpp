// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "matchers.h"
#include "shapes.h"

namespace test_fuzz_findings {

// Bugs found by the fuzzers, one test each.

using Canonical_pose_test::Triangle_soup;
using CGAL::Canonical_pose_3::Options;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

// Half of the cells of a pose after two iterations may be inverted: they are not untangled.
Options two_iterations()
{
  Options options;
  options.number_of_landmarks = 6;
  options.registration.number_of_iterations = 2;
  options.registration.injective = false;
  return options;
}

// There is a pose, and it is finite.
void expect_pose(const Triangle_soup& soup, const Options& options)
{
  std::vector<Point_3> points, pose;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  EXPECT_TRUE(CGAL::canonical_pose_3(points, soup.triangles, pose, options).is_usable());
  ASSERT_EQ(pose.size(), points.size());
  for(const Point_3& p : pose)
    EXPECT_TRUE(CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z()));
}

// Chords that end on the cap of a hole have no vertex at their end: an out-of-range vertex was
// used.
TEST(Fuzz_findings, icosahedron_with_a_hole_and_a_reversed_face)
{
  Triangle_soup soup = Canonical_pose_test::icosphere_soup(0, 1);
  soup.triangles.erase(soup.triangles.begin() + 14);
  std::swap(soup.triangles[13][0], soup.triangles[13][1]);
  Options options = two_iterations();
  options.components = Options::Components::EACH;
  expect_pose(soup, options);
}

// The surface was sampled for cubes of this size, requiring gigabytes, before the size was checked.
TEST(Fuzz_findings, spacing_far_too_small)
{
  Options options;
  options.lattice_spacing = 1e-9;
  EXPECT_THROW_WITH(expect_pose(Canonical_pose_test::icosphere_soup(0, 1), options),
                    std::invalid_argument, "spacing");
}

// Isolated vertices are attached to the nearest triangle: its plane was computed even if it was
// degenerate, and in coordinates whose fourth powers overflow.
TEST(Fuzz_findings, carried_by_a_flat_face_and_at_any_size)
{
  Options options = two_iterations();
  options.lattice_spacing = 0.1;
  for(const int exponent : {-290, 0, 290})
  {
    Triangle_soup soup = Canonical_pose_test::icosphere_soup(1, 1);
    const auto [a, b, c] = soup.triangles[0];
    for(std::size_t k = 0; k < 3; ++k)
      soup.points[c][k] = (soup.points[a][k] + soup.points[b][k]) / 2;
    soup.points.push_back({2 * soup.points[c][0], 2 * soup.points[c][1], 2 * soup.points[c][2]});
    soup.points.push_back(soup.points[c]);
    for(auto& p : soup.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    expect_pose(soup, options);
  }
}

// Orienting the faces of such a cell did not terminate.
TEST(Fuzz_findings, cell_that_names_a_vertex_twice)
{
  CGAL::Canonical_pose_3::Indexed_tetrahedra_3<Point_3> complex;
  complex.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  complex.cells = {{0, 1, 2, 3}, {0, 4, 4, 3}};
  CGAL::Surface_mesh<Point_3> mesh;
  std::map<CGAL::Surface_mesh<Point_3>::Vertex_index, std::size_t> origin;
  EXPECT_THROW_WITH(
    CGAL::Canonical_pose_3::extract_boundary(complex, mesh, boost::make_assoc_property_map(origin)),
    std::invalid_argument, "cell 1 names a vertex twice");
}

} // namespace test_fuzz_findings
