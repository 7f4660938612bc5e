// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The steps of the one call, called one after the other, are the one call: the same computation, hence the same bytes.

#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::Polygon_soup;
using shapes::pose_of;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

CP::Result by_steps(const CP::Prepared_surface_3& prepared)
{
  std::vector<CP::Result> results;
  for(const auto& [surface, options] : prepared.components)
  {
    const CP::Landmark_fields_3 fields = CP::landmark_fields(surface, options);
    const CP::Target_3 target = CP::mds_target(surface, fields, options);
    const CP::Surface_body_3 body = CP::surface_body(surface, fields, options);
    results.push_back(CP::registered_pose(surface, target, body, options));
  }
  return CP::joined_result(prepared, results);
}

void expect_same(const Polygon_soup& soup, const CP::Options& options)
{
  const CP::Result expected = pose_of(soup, options);
  const CP::Result result
    = by_steps(CP::prepare_surface(shapes::to_matrix(soup.points), soup.polygons, options));
  EXPECT_EQ(result.pose, expected.pose);
  EXPECT_EQ(result.pose_of_followers, expected.pose_of_followers);
  EXPECT_EQ(*result.target, *expected.target);
  EXPECT_EQ(result.brief_report().substr(0, 40), expected.brief_report().substr(0, 40));
  EXPECT_EQ(result.summary.warnings, expected.summary.warnings);
  EXPECT_EQ(result.summary.input.vertices, expected.summary.input.vertices);
}

template <class Triangle_mesh>
void expect_same_on_mesh()
{
  const auto soup = shapes::bent_bar();
  auto mesh = CP::make_triangle_mesh<Triangle_mesh>(shapes::to_matrix(soup.points), soup.triangles);
  const CP::Result result = by_steps(CP::prepare_surface(mesh));
  EXPECT_EQ(result.pose, CGAL::canonical_pose_3(mesh, get(CGAL::vertex_point, mesh)).pose);
}

} // namespace

TEST(Pose_steps, on_meshes)
{
  expect_same_on_mesh<Mesh>();
  expect_same_on_mesh<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>();
}

// Options in the rows of the input come to those of the components, results go back.
TEST(Pose_steps, on_soups)
{
  CP::Options options;
  expect_same(shapes::unsewn(shapes::bar()), options);

  const Polygon_soup soup = shapes::with_isolated_vertices(shapes::bar(), 3);
  const Eigen::Index n = Eigen::Index(soup.points.size());
  options.matching_weights = Eigen::VectorXd::LinSpaced(n, 0.5, 2);
  options.stiffness = Eigen::VectorXd::LinSpaced(n, 1, 3);
  options.constraints.springs = {{4, 60, 1., 0.2}};
  options.constraints.handles = {{9, Eigen::RowVector3d(1, 2, 3), 0.1}};
  options.followers = shapes::to_matrix(soup.points).topRows(7);
  expect_same(soup, options);

  options = shapes::each_component();
  options.followers = Point_matrix::Ones(1, 3);
  expect_same(shapes::merged(shapes::small_bar(), shapes::bar(), 20.), options);
}

// The target is that of its distances, body and length are those of the others.
TEST(Pose_steps, distances_of_the_target_alone)
{
  CP::Options heat, wavefront, both;
  wavefront.geodesics = CP::Options::Geodesics::WAVEFRONT;
  heat.number_of_landmarks = wavefront.number_of_landmarks = both.number_of_landmarks = 30;
  both.target_fields_function = CP::landmark_fields_function<CP::Wavefront_geodesics_3<Mesh>>();
  const auto prepared
    = CP::prepare_surface(shapes::to_matrix(shapes::bar().points), shapes::bar().polygons, heat);
  const auto& surface = prepared.components.front().surface;
  const auto heat_fields = CP::landmark_fields(surface, heat);
  const auto path_fields
    = both.target_fields_function(surface.points, surface.triangles, 30, heat_fields.landmarks[0]);
  const auto target = CP::mds_target(surface, path_fields, heat);
  const auto body = CP::surface_body(surface, heat_fields, heat);
  EXPECT_EQ(body.length_scale, heat_fields.distances.maxCoeff());
  EXPECT_NE(body.length_scale, path_fields.distances.maxCoeff());
  const CP::Result result = pose_of(shapes::bar(), both);
  EXPECT_EQ(result.pose, CP::registered_pose(surface, target, body, heat).pose);
  EXPECT_NE(result.pose, pose_of(shapes::bar(), heat).pose);
}

// A target that is twice as large gives a pose of a larger volume. With a limit it is scaled down, by the power of the
// volume that suits the default detail length, so that the volume is near the limit.
TEST(Pose_steps, volume_of_a_given_target)
{
  CP::Options options;
  options.given = pose_of(shapes::bar(), options);
  *options.given.target *= 2;
  const CP::Result large = pose_of(shapes::bar(), options);
  EXPECT_EQ(large.summary.target.scale, 1);
  EXPECT_GT(large.summary.volume_ratio, 1.5);
  options.volume_ratio_limit = 1.15;
  const CP::Result limited = pose_of(shapes::bar(), options);
  EXPECT_LT(limited.summary.target.scale, 1);
  EXPECT_NEAR(limited.summary.volume_ratio, 1.15, 0.2);
  EXPECT_EQ(*limited.target, *options.given.target); // as it was given

  options.volume_ratio_limit = 0;
  EXPECT_THROW_WITH(pose_of(shapes::bar(), options), std::invalid_argument, "volume_ratio_limit");
}

// The pose for other options is that of a call with these.
TEST(Pose_steps, steps_are_used_again)
{
  const auto prepared
    = CP::prepare_surface(shapes::to_matrix(shapes::bar().points), shapes::bar().polygons);
  const auto& [surface, given_options] = prepared.components.front();
  CP::Options options = given_options;
  const auto fields = CP::landmark_fields(surface, options);
  const auto target = CP::mds_target(surface, fields, options);
  const auto body = CP::surface_body(surface, fields, options);
  for(const double detail_length : {0.05, 0.2})
  {
    options.registration.detail_length = detail_length;
    CP::Options whole;
    whole.registration.detail_length = detail_length;
    EXPECT_EQ(CP::registered_pose(surface, target, body, options).pose,
              pose_of(shapes::bar(), whole).pose);
  }
}

TEST(Pose_steps, what_does_not_fit_is_refused)
{
  const auto prepared
    = CP::prepare_surface(shapes::to_matrix(shapes::bar().points), shapes::bar().polygons);
  const auto& [surface, options] = prepared.components.front();
  EXPECT_THROW(CP::joined_result(prepared, {}), CGAL::Precondition_exception);
  auto fields = CP::landmark_fields(surface, options);
  const auto target = CP::mds_target(surface, fields, options);
  const auto body = CP::surface_body(surface, fields, options);
  CP::Target_3 short_target = target;
  short_target.points.conservativeResize(5, 3);
  EXPECT_THROW(CP::registered_pose(surface, short_target, body, options),
               CGAL::Precondition_exception);
  fields.distances.conservativeResize(5, fields.distances.cols());
  EXPECT_THROW(CP::mds_target(surface, fields, options), CGAL::Precondition_exception);
  EXPECT_THROW(CP::surface_body(surface, fields, options), CGAL::Precondition_exception);
  EXPECT_THROW_WITH(CP::prepare_surface(Point_matrix(), {}), std::invalid_argument, "no face");
}
