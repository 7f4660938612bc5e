// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// canonical_pose_3() with the target of unfolding.

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"
#include "threads.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace test_unfolding_of_the_call {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using Point = CGAL::Simple_cartesian<double>::Point_3;

CP::Options unfolding()
{
  CP::Options options;
  options.target_mode = CP::Options::Target_mode::UNFOLDING;
  return options;
}

// The distance between the ends of the bent bar, whose first and last vertices are there.
double distance_of_ends(const Point_matrix& pose)
{
  return (pose.row(0) - pose.row(pose.rows() - 1)).norm();
}

template <class Triangles>
double area(const Point_matrix& points, const Triangles& triangles)
{
  double sum = 0;
  for(const auto& t : triangles)
  {
    const auto corner = [&](const std::size_t k) {
      return Eigen::Vector3d(points.row(static_cast<Eigen::Index>(t[k])));
    };
    sum += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return sum;
}

// The call is its steps with the target of unfolding. L is the largest distance to the first two
// landmarks; the lattice is based on all of them. The bar was bent by 2 radians.
TEST(Unfolding_of_the_call, is_the_sum_of_its_steps)
{
  const shapes::Triangle_soup soup = shapes::bent_bar();
  const CP::Options options = unfolding();
  const CP::Result result = shapes::pose_of(soup, options);
  EXPECT_TRUE(result.summary.converged());
  EXPECT_EQ(result.summary.inverted, 0u);
  EXPECT_TRUE(result.summary.rounds.empty());
  EXPECT_EQ(result.summary.target.kernel, "unfolding");
  EXPECT_EQ(result.summary.target.landmarks, 80u);
  EXPECT_FALSE(result.summary.target.reflected);
  EXPECT_GT(distance_of_ends(result.pose), 1.1 * distance_of_ends(shapes::to_matrix(soup.points)));

  const CP::Prepared_surface_3 prepared
    = CP::prepare_surface(shapes::to_matrix(soup.points), shapes::bar().polygons, options);
  const auto& [surface, local] = prepared.components[0];
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, local);
  const CP::Landmark_fields_3 fields = CP::landmark_fields(coarse, local);
  const CP::Surface_body_3 body = CP::surface_body(surface, coarse, fields, local);
  EXPECT_EQ(body.length_scale, fields.distances.leftCols(2).maxCoeff());
  EXPECT_EQ(result.summary.target.max_geodesic, body.length_scale);
  const CP::Target_3 target = CP::unfolded_target(surface, body, local);
  EXPECT_NEAR(area(target.points, surface.triangles), area(surface.points, surface.triangles),
              1e-9);
  const CP::Result joined = CP::joined_result(
    prepared, {CP::registered_pose(surface, coarse, fields, target, body, local)});
  EXPECT_EQ(joined.pose, result.pose);
  EXPECT_EQ(joined.summary.energy, result.summary.energy);
}

// Poses of the bent bar and of the straight one are nearly the same, a tenth of the difference of the
// inputs remains.
TEST(Unfolding_of_the_call, bent_and_straight_bars_have_the_same_pose)
{
  const shapes::Triangle_soup bent = shapes::bent_bar();
  const shapes::Triangle_soup straight
    = shapes::boundary(shapes::tetrahedral_bent_bar(48, 6, 6, 0.));
  const double before
    = shapes::relative_rms(shapes::to_matrix(bent.points), shapes::to_matrix(straight.points));
  const double after = shapes::relative_rms(shapes::pose_of(bent, unfolding()).pose,
                                            shapes::pose_of(straight, unfolding()).pose);
  EXPECT_LT(after, before / 5);
}

// The pose follows motions and scaling of the input, up to rounding, and ties between landmarks: the bar is
// sheared and bent once more, as the axes of the lattice of a symmetric one have signs by rounding.
TEST(Unfolding_of_the_call, pose_follows_motions_and_scaling)
{
  shapes::Triangle_soup soup = shapes::bent_bar();
  for(auto& p : soup.points)
    p[2] += 0.2 * p[0] + 0.05 * p[0] * p[0];
  CP::Options options = unfolding();
  options.registration.injective = false;
  const Point_matrix pose = shapes::pose_of(soup, options).pose;
  for(auto& p : soup.points)
    p = {{7 - 10 * p[1], 3 + 10 * p[0], 10 * p[2]}};
  const Point_matrix moved = shapes::pose_of(soup, options).pose;
  EXPECT_LT(shapes::relative_rms(moved / 10, pose), 1e-3);
}

// Each component is unfolded on its own; the pose of both is that of one, twice, up to ties.
TEST(Unfolding_of_the_call, components_are_unfolded_one_by_one)
{
  CP::Options options = unfolding();
  options.lattice_spacing = .03; // components share the cells otherwise
  const CP::Result one = shapes::pose_of(shapes::bent_bar(), options);
  options.components = CP::Options::Components::EACH;
  const CP::Result two = shapes::pose_of(shapes::two_bars(), options);
  const Eigen::Index n = one.pose.rows();
  EXPECT_LT(shapes::relative_rms(two.pose.topRows(n), one.pose), 5e-3);
  EXPECT_LT(shapes::relative_rms(two.pose.bottomRows(n), one.pose), 5e-3);
}

// A complex is its own body, so that two distance fields are sufficient; constraints and followers act
// as with any target.
TEST(Unfolding_of_the_call, complexes_and_constraints)
{
  const shapes::Tetrahedral_soup soup = shapes::tetrahedral_bent_bar(24, 3, 3, 2.);
  CP::Indexed_tetrahedra_3<Point> complex;
  for(const auto& p : soup.points)
    complex.points.emplace_back(p[0], p[1], p[2]);
  for(const auto& c : soup.cells)
    complex.cells.push_back({{c[0], c[1], c[2], c[3]}});
  std::vector<Point> points(complex.points.size());
  CP::Options options = unfolding();
  options.followers = shapes::to_matrix(soup.points).topRows(10);
  const CP::Result free = CGAL::canonical_pose_3(complex, CGAL::make_property_map(points), options);
  EXPECT_TRUE(free.summary.converged());
  EXPECT_EQ(free.summary.target.landmarks, 2u);
  EXPECT_EQ(free.summary.body.kind, "complex");
  EXPECT_LT((free.pose_of_followers - free.pose.topRows(10)).cwiseAbs().maxCoeff(), 1e-9);

  const std::size_t last = soup.points.size() - 1;
  options.constraints.springs.push_back({0, last, 3., 10.});
  const CP::Result held = CGAL::canonical_pose_3(complex, CGAL::make_property_map(points), options);
  EXPECT_GT(distance_of_ends(free.pose), 7);
  EXPECT_LT(distance_of_ends(held.pose), 5);
}

TEST(Unfolding_of_the_call, number_of_threads_does_not_matter)
{
  const shapes::Triangle_soup soup = shapes::bent_bar();
  const CP::Result first = shapes::pose_of(soup, unfolding());
  shapes::with_each_number_of_threads(
    [&] { EXPECT_EQ(shapes::pose_of(soup, unfolding()).pose, first.pose); });
}

// Options about other targets are refused instead of being ignored.
TEST(Unfolding_of_the_call, options_of_other_targets_are_refused)
{
  const shapes::Triangle_soup soup = shapes::bent_bar();
  const auto refuses = [&](const CP::Options& options, const char* const name) {
    EXPECT_THROW_WITH(shapes::pose_of(soup, options), std::invalid_argument, name);
  };
  CP::Options options = unfolding();
  options.given.target = shapes::to_matrix(soup.points);
  refuses(options, "given.target");
  options = unfolding();
  options.takes_mirror_image = true;
  refuses(options, "takes_mirror_image");
  for(CP::Options any : {unfolding(), CP::Options()}) // also where it is not used
  {
    any.unfolding.weight = -1;
    refuses(any, "option unfolding.weight");
  }
}

} // namespace test_unfolding_of_the_call
