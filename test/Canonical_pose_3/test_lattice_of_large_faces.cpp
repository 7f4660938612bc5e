// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/lattice/Edge_splitter.h"
#include "engine/lattice/surface_chords.h"
#include "engine/surface/signed_volume.h"

#include <CGAL/Canonical_pose_3/Lattice_body_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "matchers.h"
#include "shapes.h"

namespace test_lattice_of_large_faces {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

// The body based on Euclidean distances, which are suitable for convex shapes, and nearly so for a
// torus.
CP::Lattice_body_3 body(const shapes::Triangle_soup& soup, const double spacing = 0)
{
  const CP::Point_matrix points = shapes::to_matrix(soup.points);
  const Eigen::Index l = (std::min)(points.rows(), Eigen::Index(16));
  Eigen::MatrixXd distances(points.rows(), l);
  for(Eigen::Index j = 0; j < l; ++j)
    distances.col(j) = (points.rowwise() - points.row(j * (points.rows() / l))).rowwise().norm();
  return CP::Lattice_body_3(points, soup.triangles, distances, spacing);
}

double volume(const shapes::Triangle_soup& soup)
{
  return CP::internal::signed_volume(shapes::to_matrix(soup.points), soup.triangles) / 6;
}

double volume_ratio(const shapes::Triangle_soup& soup, const double spacing = 0)
{
  return body(soup, spacing).volume() / volume(soup);
}

shapes::Triangle_soup box(const double x, const double y, const double z)
{
  return shapes::boundary(shapes::tetrahedral_box(1, 1, 1, {{x, y, z}}));
}

// The filled parts of the cubes add up to the volume of the solid, within the accuracy of 27 points
// per cube for a planar face: a sixth of a cube. Cubes with several copies, because parts of a face
// were mistaken for parts of another limb, were counted several times: 1.95 for the long box, 2.76
// for the cube, 1.69 and 1.53 below.
TEST(Lattice_of_large_faces, boxes)
{
  EXPECT_NEAR(volume_ratio(box(9., 1., 0.7)), 1, 0.03);
  EXPECT_NEAR(volume_ratio(box(1., 1.1, 1.2)), 1, 0.03);
  EXPECT_NEAR(volume_ratio(box(1., 0.9, 0.05)), 1, 0.05);
  // thinner than a cube, in steps of a third of the cube
  EXPECT_NEAR(volume_ratio(box(1., 0.9, 0.01), 0.01), 1, 0.15);
}

TEST(Lattice_of_large_faces, round_shapes)
{
  for(const unsigned int subdivisions : {0u, 1u, 2u, 3u})
    EXPECT_NEAR(volume_ratio(shapes::icosphere_soup(subdivisions, 1.)), 1, 0.02);
  EXPECT_NEAR(volume_ratio(shapes::torus_soup(12, 6, 1., 0.4)), 1, 0.02);
  EXPECT_NEAR(volume_ratio(shapes::tube_soup(2, 40, 10., 0.3)), 1, 0.04);
  EXPECT_NEAR(volume_ratio(shapes::tube_soup(2, 6, 10., 0.3)), 1, 0.03);
}

// The vertices and faces of the surface are unchanged, regardless of how the body splits them.
TEST(Lattice_of_large_faces, embeds_the_vertices_given)
{
  const shapes::Triangle_soup soup = shapes::icosphere_soup(1, 1.);
  const CP::Lattice_body_3 b = body(soup);
  ASSERT_EQ(b.embedding().rows(), Eigen::Index(soup.points.size()));
  EXPECT_LE((b.embedding() * b.points() - shapes::to_matrix(soup.points)).cwiseAbs().maxCoeff(),
            1e-13);
}

// Splitting moves nothing: area and volume do not change, a closed surface remains closed (each
// directed edge has one opposite edge), new vertices are midpoints, and no edge is too long.
TEST(Lattice_of_large_faces, edges_are_split)
{
  const double longest = 0.3;
  for(const shapes::Triangle_soup& soup :
      {box(9., 1., 0.2), shapes::tube_soup(2, 12, 5., 0.3), shapes::icosphere_soup(1, 1.)})
  {
    shapes::Triangles triangles = soup.triangles;
    CP::internal::Row_points points = shapes::to_matrix(soup.points);
    const CP::internal::Edge_splitter splitter(points, triangles, longest);
    ASSERT_EQ(std::size_t(points.rows()), soup.points.size() + splitter.edges().size());
    for(std::size_t i = 0; i < splitter.edges().size(); ++i)
    {
      const auto [v, w] = splitter.edges()[i];
      EXPECT_LT((std::max)(v, w), soup.points.size() + i);
      EXPECT_EQ(points.row(Eigen::Index(soup.points.size() + i)),
                (points.row(Eigen::Index(v)) + points.row(Eigen::Index(w))) / 2);
    }
    std::map<std::pair<std::size_t, std::size_t>, int> sides;
    for(const auto& t : triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        ++sides[{t[k], t[(k + 1) % 3]}];
        EXPECT_LE(
          (points.row(Eigen::Index(t[k])) - points.row(Eigen::Index(t[(k + 1) % 3]))).norm(),
          longest);
      }
    for(const auto& [side, number] : sides)
    {
      EXPECT_EQ(number, 1);
      EXPECT_EQ(sides.count({side.second, side.first}), 1u);
    }
    EXPECT_NEAR(CP::internal::signed_volume(points, triangles) / 6, volume(soup), 1e-13);
  }
}

// The work is bounded by enlarging the steps: for large steps, there is only one sample per face,
// so this terminates for any number of faces.
TEST(Lattice_of_large_faces, number_of_samples)
{
  const shapes::Triangle_soup soup = shapes::icosphere_soup(3, 1.);
  const CP::internal::Row_points points = shapes::to_matrix(soup.points);
  const CP::internal::Sample_bound bound(points, soup.triangles);
  EXPECT_LT(bound(1e6), 0.01);
  for(const double step : {0.3, 0.1, 0.01})
  {
    std::size_t number = 0;
    for(const auto& t : soup.triangles)
      CP::internal::for_each_sample(points, t, step, [&](const Eigen::Vector3d&) { ++number; });
    EXPECT_LE(double(number), double(soup.triangles.size()) + bound(step));
  }
}

} // namespace test_lattice_of_large_faces
