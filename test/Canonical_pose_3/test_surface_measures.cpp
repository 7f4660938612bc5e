// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What single functions of surface_measures.h and triangulate_polygons.h return for shapes where the
// answer is known.

#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/triangulate_polygons.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_surface_measures {

namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;

// The corners of the unit square, and a vertex of its own.
Point_matrix square()
{
  Point_matrix points(5, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 7, 7, 7;
  return points;
}

const std::vector<std::array<std::size_t, 3>> TRIANGLES = {{0, 1, 2}, {0, 2, 3}};

// An edge of two triangles counts once, and the vertex without edges has no strain.
TEST(Vertex_strains, stretched_square)
{
  Point_matrix pose = square();
  pose.col(0) *= 2;
  const double horizontal = std::log(2.), diagonal = std::log(std::sqrt(2.5));
  const Eigen::VectorXd strains = CP::vertex_strains(square(), pose, TRIANGLES);
  EXPECT_NEAR(strains[0], (horizontal + diagonal) / 3, 1e-15);
  EXPECT_NEAR(strains[1], horizontal / 2, 1e-15);
  EXPECT_NEAR(strains[2], (horizontal + diagonal) / 3, 1e-15);
  EXPECT_EQ(strains[4], 0);
  EXPECT_NEAR(CP::median_edge_strain(square(), pose, TRIANGLES), diagonal, 1e-15);
}

TEST(Vertex_strains, of_a_tetrahedron_has_six_edges)
{
  Point_matrix rest(4, 3);
  rest << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  const std::vector<std::array<std::size_t, 4>> cell = {{0, 1, 2, 3}};
  for(const double scale : {2., 1e-200, 1e200})
  {
    const Eigen::VectorXd strains = CP::vertex_strains(rest, Point_matrix(scale * rest), cell);
    for(const double strain : strains)
      EXPECT_NEAR(strain, std::abs(std::log(scale)), 1e-12 * strain);
  }
}

TEST(Vertex_strains, edges_without_length_are_ignored)
{
  Point_matrix pose = square();
  pose.row(3) = pose.row(0);
  const Eigen::VectorXd strains = CP::vertex_strains(square(), pose, TRIANGLES);
  EXPECT_TRUE(strains.allFinite());
  EXPECT_EQ(strains[1], 0);
}

TEST(Vertex_normals, are_unit_or_zero_in_any_unit)
{
  for(const double scale : {1., 1e-200, 1e200})
  {
    const Point_matrix normals = CP::vertex_normals(scale * square(), TRIANGLES);
    for(int v = 0; v < 4; ++v)
      EXPECT_EQ(normals.row(v), Eigen::RowVector3d(0, 0, 1)) << scale;
    EXPECT_TRUE(normals.row(4).isZero(0));
  }
}

// The second corner of the arrow is reflex: a fan around the first one would leave the polygon.
TEST(Triangulate_polygons, arrow)
{
  for(const double scale : {1., 1e200, 1e-200})
  {
    Point_matrix points(4, 3);
    points << 0, 3, 0, -2, 0, 0, 0, 1, 0, 2, 0, 0;
    points *= scale;
    const CP::Triangulated_polygons result
      = CP::triangulate_polygons(points, {{1, 2, 3, 0}, {0, 0, 1}, {0, 1, 2}});
    ASSERT_EQ(result.triangles.size(), 4u);
    EXPECT_EQ(result.polygon_of_triangle, (std::vector<std::size_t>{0, 0, 1, 2}));
    EXPECT_EQ(result.triangles[2], (std::array<std::size_t, 3>{0, 0, 1})); // as it was
    for(int t = 0; t < 2; ++t)
    {
      const auto& c = result.triangles[t];
      const Eigen::RowVector3d e = (points.row(c[1]) - points.row(c[0])) / scale;
      const Eigen::RowVector3d f = (points.row(c[2]) - points.row(c[0])) / scale;
      EXPECT_GT(e.cross(f)[2], 0) << t;
    }
  }
}

} // namespace test_surface_measures
