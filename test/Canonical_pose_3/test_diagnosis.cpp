// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "diagnosed.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_diagnosis {

// Each count is known by construction of the shape.

using namespace Canonical_pose_test;

TEST(Diagnosis, nothing_wrong)
{
  EXPECT_EQ(defects(ball()), Defects());
  EXPECT_TRUE(diagnosis(ball()).is_clean());
  EXPECT_EQ(diagnosis(ball()).self_intersections, 0u);
}

// Vertices are those of the complex, one of which is inside, and cells may touch at one.
TEST(Diagnosis, tetrahedral_complex)
{
  CGAL::Canonical_pose_3::Point_matrix points(9, 3);
  points << 9, 9, 9, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, .2, .2, .2;
  const std::vector<std::array<std::size_t, 4>> cells
    = {{{7, 4, 5, 6}}, {{8, 1, 2, 3}}, {{8, 1, 3, 7}}, {{8, 1, 7, 2}}, {{8, 2, 7, 3}}};
  const auto found = CGAL::Canonical_pose_3::diagnose(points, cells);
  EXPECT_EQ(found.vertices, 7u);
  EXPECT_EQ(found.faces, 8u);
  EXPECT_EQ(found.isolated_vertices, 0u);
  EXPECT_EQ(found.self_intersections, 0u);
  ASSERT_EQ(found.defects.size(), 1u);
  EXPECT_EQ(found.first_defect, "vertex 7 is not manifold: 2 fans of faces meet there");
}

TEST(Diagnosis, no_face)
{
  EXPECT_EQ(defects({}), Defects({"no_faces 1"}));
  EXPECT_FALSE(diagnosis({}).is_clean());
  EXPECT_FALSE(diagnosis({}).self_intersections);
}

TEST(Diagnosis, polygons)
{
  EXPECT_EQ(defects(quad_cube()), Defects({"polygons 6"}));
  EXPECT_TRUE(diagnosis(quad_cube()).is_clean());
  EXPECT_EQ(diagnosis(quad_cube()).first_defect, "face 0 is not a triangle");
}

TEST(Diagnosis, triangle_soup_of_a_file_without_vertices)
{
  EXPECT_EQ(defects(unsewn(ball())),
            Defects({"components 20", "holes 20", "duplicated_points 48"}));
}

TEST(Diagnosis, isolated_and_duplicated_vertices)
{
  Polygon_soup soup = ball();
  soup.points.push_back(soup.points[4]);
  EXPECT_EQ(defects(soup), Defects({"isolated_vertices 1", "duplicated_points 1"}));
  EXPECT_EQ(diagnosis(soup).defects[1].examples[0], std::vector<std::size_t>({4, 12}));
}

TEST(Diagnosis, degenerate_and_duplicate_faces)
{
  Polygon_soup soup = ball();
  soup.polygons.push_back({0, 0, 1});
  soup.polygons.push_back({3});
  EXPECT_EQ(diagnosis(soup).degenerate_faces, 2u);
  EXPECT_EQ(diagnosis(soup).defects[0].examples, Polygons({{20}, {21}}));
  EXPECT_EQ(diagnosis(soup).first_defect, "face 20 is degenerate");

  soup = ball();
  soup.polygons.push_back({soup.polygons[5][1], soup.polygons[5][0], soup.polygons[5][2]});
  EXPECT_EQ(defects(soup), Defects({"duplicate_faces 1", "non_manifold_edges 3"}));
  EXPECT_EQ(diagnosis(soup).defects[0].examples, Polygons({{20}}));
}

TEST(Diagnosis, flipped_patch)
{
  Polygon_soup soup = ball();
  std::swap(soup.polygons[4][0], soup.polygons[4][1]);
  EXPECT_EQ(defects(soup), Defects({"inconsistent_orientation 3"}));
  EXPECT_EQ(diagnosis(soup).non_manifold_edges, 3u);
  EXPECT_NE(diagnosis(soup).first_defect.find("opposite orientation"), std::string::npos);
}

TEST(Diagnosis, inside_out)
{
  Polygon_soup soup = ball();
  for(auto& polygon : soup.polygons)
    std::swap(polygon[0], polygon[1]);
  EXPECT_EQ(defects(soup), Defects({"inside_out 1"}));
  EXPECT_TRUE(diagnosis(soup).is_clean());
}

TEST(Diagnosis, edges_and_vertices_that_are_not_manifold)
{
  EXPECT_EQ(defects(pinched_balls()), Defects({"non_manifold_vertices 1", "isolated_vertices 1"}));
  EXPECT_EQ(diagnosis(pinched_balls()).components, 1u);
  EXPECT_EQ(defects(ball_with_fin()), Defects({"non_manifold_edges 1", "holes 1"}));
  EXPECT_EQ(diagnosis(ball_with_fin()).first_defect,
            "the edge from vertex 0 to vertex 11 belongs to 3 faces");
  EXPECT_EQ(
    defects(cubes_with_a_common_edge()),
    Defects({"non_manifold_edges 1", "isolated_vertices 2", "duplicated_points 2", "polygons 12"}));
}

TEST(Diagnosis, components_holes_and_intersections)
{
  EXPECT_EQ(defects(merged(ball(), ball(), 5.)), Defects({"components 2"}));
  Polygon_soup soup = ball();
  soup.polygons.erase(soup.polygons.begin() + 13);
  soup.polygons.erase(soup.polygons.begin());
  EXPECT_EQ(defects(soup), Defects({"holes 2"}));
  EXPECT_EQ(diagnosis(soup).boundary_edges, 6u);
  EXPECT_GT(diagnosis(merged(ball(), ball(), 0.5)).self_intersections, 0u);
  // also if the surface is not manifold: a face through the ball, attached to one of its edges
  soup = ball_with_fin();
  soup.points[12] = {{3., -3., 0.5}};
  EXPECT_GT(diagnosis(soup).self_intersections, 0u);
}

} // namespace test_diagnosis
