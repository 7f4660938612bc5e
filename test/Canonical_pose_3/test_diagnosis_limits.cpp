// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "diagnosed.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test_diagnosis_limits {

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

// All of them are listed, and nothing else is examined.
TEST(Diagnosis, wrong_values)
{
  Polygon_soup soup = ball();
  soup.polygons[7][1] = 12;
  soup.polygons[9] = {14, 13, 12};
  soup.points[3][2] = std::numeric_limits<double>::quiet_NaN();
  soup.points[5][0] = std::numeric_limits<double>::infinity();
  const CP::Diagnosis_3 d = diagnosis(soup);
  using Examples = std::vector<std::vector<std::size_t>>;
  ASSERT_EQ(d.defects.size(), 2u);
  EXPECT_EQ(d.defects[0].kind, "not_finite");
  EXPECT_EQ(d.defects[0].count, 2u);
  EXPECT_EQ(d.defects[0].examples, (Examples{{3}, {5}}));
  EXPECT_EQ(d.first_defect, "vertex 3 has a coordinate that is not finite");
  EXPECT_EQ(d.defects[1].kind, "wrong_indices");
  EXPECT_EQ(d.defects[1].examples, (Examples{{7}, {9}}));
  EXPECT_EQ(d.defects[1].message, "face 7 names vertex 12, but there are 12");
  EXPECT_FALSE(d.is_clean());
  const CP::Point_matrix corners = CP::Point_matrix::Identity(3, 3);
  const CP::Diagnosis_3 of_cells
    = CP::diagnose(corners, std::vector<std::array<std::size_t, 4>>{{0, 1, 2, 3}});
  EXPECT_EQ(of_cells.first_defect, "cell 0 names vertex 3, but there are 3");
}

// All pairs of 1500 faces intersect, more than a million; the search stops at its bound.
TEST(Diagnosis, search_for_intersections_is_bounded)
{
  Polygon_soup soup;
  for(std::size_t i = 0; i < 1500; ++i)
  {
    const double u = pi * double(i) / 1500;
    soup.points.push_back({{std::cos(u), std::sin(u), -1.}});
    soup.points.push_back({{-std::cos(u), -std::sin(u), -1.}});
    soup.points.push_back({{0., 0., 1. + double(i)}});
    soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_EQ(diagnosis(soup).self_intersections,
            std::size_t(CP::Diagnosis_3::MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS));
}

TEST(Diagnosis, counts_do_not_depend_on_labels_and_scale)
{
  for(const Polygon_soup& soup : {quad_cube(), unsewn(ball()), pinched_balls(), ball_with_fin(),
                                  cubes_with_a_common_edge(), moebius_strip(20)})
  {
    EXPECT_EQ(defects(soup), defects(relabeled(soup)));
    for(const double scale : {1e150, 1e-150})
    {
      Polygon_soup scaled = soup;
      for(auto& p : scaled.points)
        p = {{scale * p[0], scale * p[1], scale * p[2]}};
      EXPECT_EQ(defects(soup), defects(scaled));
    }
  }
}

TEST(Diagnosis, polygon_mesh)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> cube;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), cube);
  EXPECT_EQ(CP::diagnose(cube, get(CGAL::vertex_point, cube)).polygons, 6u);
}

} // namespace test_diagnosis_limits
