// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/lattice/surface_chords.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "matchers.h"
#include "shapes.h"

namespace test_surface_chords {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

using CP::internal::Chord;

Eigen::MatrixXd straight_distances(const shapes::Triangle_soup& soup)
{
  const CP::Point_matrix points = shapes::to_matrix(soup.points);
  const Eigen::Index step = points.rows() / 20;
  Eigen::MatrixXd result(points.rows(), 20);
  for(Eigen::Index j = 0; j < 20; ++j)
    result.col(j) = (points.rowwise() - points.row(j * step)).rowwise().norm();
  return result;
}

struct Chords
{
  Chords(const shapes::Triangle_soup& soup, const Eigen::MatrixXd& distances, const double side,
         const shapes::Triangles& caps = {})
    : points(shapes::to_matrix(soup.points)), triangles(soup.triangles),
      samples(CP::internal::sample_surface(points, triangles, side)),
      chords(CP::internal::Chord_finder(points, triangles, caps,
                                        CP::internal::Geodesic_bounds(distances, 1))(samples))
  {}
  Eigen::RowVector3d normal(const std::size_t face) const
  {
    const auto p
      = [&](const std::size_t k) { return points.row(Eigen::Index(triangles[face][k])); };
    return (p(1) - p(0)).cross(p(2) - p(0)).normalized();
  }

  CP::internal::Row_points points;
  shapes::Triangles triangles;
  std::vector<CP::internal::Surface_sample> samples;
  std::vector<Chord> chords;
};

// Chords run from their sample against the normal over their length.
void expect_straight(const Chords& c)
{
  for(const Chord& chord : c.chords)
    EXPECT_LE((chord.end - chord.start + chord.length * c.normal(chord.face).transpose()).norm(),
              1e-12);
}

shapes::Triangle_soup plate(const double z)
{
  shapes::Triangle_soup soup
    = shapes::boundary(shapes::tetrahedral_box(12, 12, 1, {{0.4, 0.4, 0.04}}));
  for(auto& p : soup.points)
    p[2] += z;
  return soup;
}

// Between parallel planes, the length is their distance, up to rounding. The opposite sides of a
// prism with an even number of sides are parallel, at distance 2 r cos(pi / sides); so are its
// ends.
TEST(Surface_chords, of_parallel_faces)
{
  const std::array<double, 3> lengths = {{1., 0.8, 0.1}};
  const shapes::Triangle_soup box = shapes::boundary(shapes::tetrahedral_box(20, 16, 2, lengths));
  const Chords slab(box, straight_distances(box), 0.05);
  EXPECT_EQ(slab.chords.size(), slab.samples.size());
  expect_straight(slab);
  for(const Chord& chord : slab.chords)
  {
    Eigen::Index axis;
    slab.normal(chord.face).cwiseAbs().maxCoeff(&axis);
    EXPECT_NEAR(chord.length, lengths[std::size_t(axis)], 1e-12);
    EXPECT_TRUE(chord.exit_vertex);
  }
  const shapes::Triangle_soup prism = shapes::tube_soup(60, 24, 10., 0.5);
  const Chords tube(prism, straight_distances(prism), 0.2);
  expect_straight(tube);
  for(const Chord& chord : tube.chords)
    EXPECT_NEAR(chord.length,
                std::abs(tube.normal(chord.face)[0]) > 0.5 ? 10. : std::cos(shapes::pi / 24),
                1e-12);
}

// Facets of the sphere differ from it by at most h^2 / 8, where h = 0.08 is the length of an edge,
// and the ray from one passes the center at a distance of at most h.
TEST(Surface_chords, of_a_ball)
{
  const shapes::Triangle_soup sphere = shapes::icosphere_soup(4, 1.);
  const Chords ball(sphere, straight_distances(sphere), 0.1);
  EXPECT_GT(ball.chords.size(), 500u);
  EXPECT_EQ(ball.chords.size(), ball.samples.size());
  expect_straight(ball);
  for(const Chord& chord : ball.chords)
    EXPECT_NEAR(chord.length, 2, 2 * 0.08 * 0.08);
}

// Both surfaces, whose distance on the surface is that along a straight line and a detour.
struct Two_parts
{
  Two_parts(const shapes::Triangle_soup& one, const shapes::Triangle_soup& other,
            const double detour)
    : soup(one), size_of_one(one.points.size())
  {
    for(const auto& t : other.triangles)
      soup.triangles.push_back({{t[0] + size_of_one, t[1] + size_of_one, t[2] + size_of_one}});
    soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
    distances = straight_distances(soup);
    const std::size_t step = soup.points.size() / static_cast<std::size_t>(distances.cols());
    for(Eigen::Index i = 0; i < distances.rows(); ++i)
      for(Eigen::Index j = 0; j < distances.cols(); ++j)
        if((static_cast<std::size_t>(i) < size_of_one)
           != (static_cast<std::size_t>(j) * step < size_of_one))
          distances(i, j) += detour;
  }

  // Chords between parallel planes end in the part where they start, at the distance of its planes.
  void expect_chords_within_parts(const double side, const double height_of_one,
                                  const double height_of_other) const
  {
    const Chords chords(soup, distances, side);
    for(const Chord& chord : chords.chords)
      if(std::abs(chords.normal(chord.face)[2]) > 0.5)
      {
        const bool is_in_one = chords.triangles[chord.face][0] < size_of_one;
        EXPECT_NEAR(chord.length, is_in_one ? height_of_one : height_of_other, 1e-12);
        ASSERT_TRUE(chord.exit_vertex);
        EXPECT_EQ(*chord.exit_vertex < size_of_one, is_in_one);
      }
    EXPECT_GT(chords.chords.size(), 400u);
  }

  shapes::Triangle_soup soup;
  std::size_t size_of_one;
  Eigen::MatrixXd distances;
};

// Two plates that overlap by half of their height, and are far apart by geodesics: the ray through
// one of them crosses the side of the other, but the chord ends at the opposite side of the first.
TEST(Surface_chords, of_overlapping_limbs)
{
  Two_parts(plate(0), plate(0.02), 0.4).expect_chords_within_parts(0.03, 0.04, 0.04);
}

// A thin plate inside a block, close to its top, as a hand that is drawn inside the trunk: seen from the bottom of the block,
// the plate is not much farther by geodesics than along the ray; seen from the plate, the top of the block is.
TEST(Surface_chords, of_a_limb_inside_another_one)
{
  const shapes::Triangle_soup block
    = shapes::boundary(shapes::tetrahedral_box(12, 12, 6, {{0.4, 0.4, 0.3}}));
  shapes::Triangle_soup inside
    = shapes::boundary(shapes::tetrahedral_box(12, 12, 1, {{0.2, 0.2, 0.02}}));
  for(auto& p : inside.points)
    p = {p[0] + 0.1, p[1] + 0.1, p[2] + 0.26};
  Two_parts(block, inside, 0.15).expect_chords_within_parts(0.02, 0.3, 0.02);
}

// A box without lid: there is no exit from its bottom, until a cap closes it.
TEST(Surface_chords, of_an_open_surface)
{
  shapes::Triangle_soup soup = shapes::boundary(shapes::tetrahedral_box(8, 8, 4, {{1., 1., 0.5}}));
  const auto is_on_top = [&](const std::size_t v) { return soup.points[v][2] == 0.5; };
  const auto lid
    = std::stable_partition(soup.triangles.begin(), soup.triangles.end(), [&](const auto& t) {
        return !std::all_of(t.begin(), t.end(), is_on_top);
      });
  const shapes::Triangles caps(lid, soup.triangles.end());
  soup.triangles.erase(lid, soup.triangles.end());
  const Eigen::MatrixXd distances = straight_distances(soup);
  const auto number_from_bottom = [](const Chords& c) {
    return std::count_if(c.chords.begin(), c.chords.end(),
                         [&](const Chord& chord) { return c.normal(chord.face)[2] < -0.5; });
  };
  const Chords open(soup, distances, 0.1), closed(soup, distances, 0.1, caps);
  EXPECT_EQ(number_from_bottom(open), 0);
  EXPECT_GT(number_from_bottom(closed), 50);
  EXPECT_EQ(closed.chords.size(), closed.samples.size());
  for(const Chord& chord : closed.chords)
  {
    const bool ends_on_cap = closed.normal(chord.face)[2] < -0.5;
    EXPECT_NEAR(chord.length, ends_on_cap ? 0.5 : 1., 1e-12);
    EXPECT_EQ(chord.exit_vertex.has_value(), !ends_on_cap);
  }
}

} // namespace test_surface_chords
