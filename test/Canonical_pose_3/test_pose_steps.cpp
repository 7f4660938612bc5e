// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps of the one call, called one after the other, are the one call: the same computation, hence the same bytes,
// with rounds and without.

#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace test_pose_steps {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::Polygon_soup;
using shapes::pose_of;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

CP::Result by_steps(const CP::Prepared_surface_3& prepared)
{
  std::vector<CP::Result> results;
  for(const auto& [surface, options] : prepared.components)
  {
    const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, options);
    const CP::Landmark_fields_3 fields = CP::landmark_fields(coarse, options);
    const CP::Target_3 target = CP::mds_target(surface, coarse, fields, options);
    const CP::Surface_body_3 body = CP::surface_body(surface, coarse, fields, options);
    results.push_back(CP::registered_pose(surface, coarse, fields, target, body, options));
  }
  return CP::joined_result(prepared, results);
}

void expect_same_rounds(const std::vector<CP::Registration_summary::Round>& rounds,
                        const std::vector<CP::Registration_summary::Round>& expected)
{
  ASSERT_EQ(rounds.size(), expected.size());
  for(std::size_t i = 0; i < rounds.size(); ++i)
  {
    EXPECT_EQ(rounds[i].stress, expected[i].stress);
    EXPECT_EQ(rounds[i].energy, expected[i].energy);
    EXPECT_EQ(rounds[i].median_edge_strain, expected[i].median_edge_strain);
  }
}

void expect_same(const Polygon_soup& soup, CP::Options options)
{
  for(const int rounds : {0, 2})
  {
    options.number_of_rounds = rounds;
    const CP::Result expected = pose_of(soup, options);
    const CP::Result result
      = by_steps(CP::prepare_surface(shapes::to_matrix(soup.points), soup.polygons, options));
    EXPECT_EQ(result.pose, expected.pose);
    EXPECT_EQ(result.pose_of_followers, expected.pose_of_followers);
    EXPECT_EQ(*result.target, *expected.target);
    EXPECT_EQ(result.brief_report().substr(0, 40), expected.brief_report().substr(0, 40));
    EXPECT_EQ(result.summary.warnings, expected.summary.warnings);
    EXPECT_EQ(result.summary.input.vertices, expected.summary.input.vertices);
    EXPECT_EQ(result.summary.rounds.empty(), rounds == 0);
    expect_same_rounds(result.summary.rounds, expected.summary.rounds);
  }
}

// The only component of the bar.
CP::Surface_component_3 surface_of_bar()
{
  return CP::prepare_surface(shapes::to_matrix(shapes::bar().points), shapes::bar().polygons)
    .components.front()
    .surface;
}

// For a coarse surface of fewer vertices than the bar has. The heat method is less accurate on it.
template <class Options_type = CP::Options>
Options_type coarse_options()
{
  Options_type options;
  options.geodesics = CP::Options::Geodesics::WAVEFRONT;
  options.number_of_coarse_vertices = 120;
  options.number_of_landmarks = 20;
  return options;
}

template <class Triangle_mesh>
void expect_same_on_mesh()
{
  const auto soup = shapes::bent_bar();
  auto mesh = CP::make_triangle_mesh<Triangle_mesh>(shapes::to_matrix(soup.points), soup.triangles);
  const CP::Result result = by_steps(CP::prepare_surface(mesh));
  EXPECT_FALSE(result.summary.rounds.empty()); // by default
  EXPECT_EQ(result.pose, CGAL::canonical_pose_3(mesh, get(CGAL::vertex_point, mesh)).pose);
}

// Vertex 5 of the input may be vertex 4 of a component: its options are not taken for those of the
// input, nor the other way round.
TEST(Pose_steps, options_of_components_have_their_own_type)
{
  static_assert(!std::is_convertible<CP::Options, CP::Component_options>::value, "");
  static_assert(!std::is_convertible<CP::Component_options, CP::Options>::value, "");
  static_assert(!std::is_constructible<CP::Component_options, CP::Options>::value, "");
  static_assert(!std::is_constructible<CP::Options, CP::Component_options>::value, "");
  const auto can_register = [](auto options) {
    return std::is_invocable<decltype(CP::registered_pose)&, CP::Surface_component_3,
                             CP::Coarse_surface_3, CP::Landmark_fields_3, CP::Target_3,
                             CP::Surface_body_3, decltype(options)>();
  };
  static_assert(decltype(can_register(CP::Component_options()))::value, "");
  static_assert(!decltype(can_register(CP::Options()))::value, "");
}

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

// Distances on a coarse surface lead to about the same pose.
TEST(Pose_steps, on_coarse_surfaces)
{
  ASSERT_LT(
    CP::coarse_surface(surface_of_bar(), coarse_options<CP::Component_options>()).vertices.size(),
    shapes::bar().points.size());
  expect_same(shapes::bar(), coarse_options());
  CP::Options fine = coarse_options();
  fine.number_of_coarse_vertices = 0;
  EXPECT_LT(shapes::relative_rms(pose_of(shapes::bar(), coarse_options()).pose,
                                 pose_of(shapes::bar(), fine).pose),
            0.15);
}

// A surface with few vertices is its own coarse surface.
TEST(Pose_steps, small_surfaces_are_not_simplified)
{
  const CP::Surface_component_3 surface = surface_of_bar();
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface);
  EXPECT_EQ(coarse.surface.points, surface.points);
  EXPECT_EQ(coarse.surface.triangles, surface.triangles);
  EXPECT_TRUE(coarse.combinations.empty());
  EXPECT_EQ(CP::landmark_fields(coarse).distances, CP::landmark_fields(surface).distances);
}

// Of given distances, those of the vertices of the coarse surface are used, and all landmarks are
// among these.
TEST(Pose_steps, given_distances_on_a_coarse_surface)
{
  const CP::Surface_component_3 surface = surface_of_bar();
  auto options = coarse_options<CP::Component_options>();
  const CP::Landmark_fields_3 given = CP::landmark_fields(surface, options);
  options.given.landmark_fields = given;
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, options);
  ASSERT_LT(coarse.vertices.size(), std::size_t(surface.points.rows()));
  const CP::Landmark_fields_3 fields = CP::landmark_fields(coarse, options);
  ASSERT_EQ(fields.landmarks.size(), given.landmarks.size());
  for(std::size_t j = 0; j < given.landmarks.size(); ++j)
    EXPECT_EQ(coarse.vertices[fields.landmarks[j]], given.landmarks[j]);
  for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
    EXPECT_EQ(fields.distances.row(Eigen::Index(i)),
              given.distances.row(Eigen::Index(coarse.vertices[i])));
}

// Rounds by hand: poses with half the detail length and larger tolerances, before the last distances a prolonged
// iteration with the detail length, the distances of the same landmarks on these poses, and the targets that are refined
// with them. If the last change is less than three quarters of the one before, the distances of the last target are
// extrapolated: here, for two rounds but not for one. Then it is made symmetric. The summary describes the first target only.
TEST(Pose_steps, of_rounds)
{
  const auto soup = shapes::bent_bar();
  const auto prepared = CP::prepare_surface(
    CP::make_triangle_mesh<Mesh>(shapes::to_matrix(soup.points), soup.triangles));
  const CP::Surface_component_3& surface = prepared.components.front().surface;
  CP::Component_options options;
  options.volume_ratio_limit = 10; // targets keep their size
  CP::Registration_options of_measurement = options.registration;
  of_measurement.detail_length /= 2;
  of_measurement.energy_tolerance = 1e-3;
  of_measurement.move_tolerance = 5e-3;
  of_measurement.injective = false;
  const auto coarse = CP::coarse_surface(surface, options);
  const auto fields = CP::landmark_fields(coarse, options);
  const auto target = CP::mds_target(surface, coarse, fields, options);
  const auto body = CP::surface_body(surface, coarse, fields, options);
  const Eigen::VectorXd shares = CP::vertex_area_shares(surface.points, surface.triangles);
  CP::Tetrahedral_arap_registrar_3 registrar(body.body, shares, body.length_scale, of_measurement,
                                             body.stiffness);
  for(const int number : {1, 2})
  {
    CP::Target_3 refined = target;
    CP::Registration_summary measured;
    CP::Landmark_fields_3 fields_of_pose;
    Point_matrix body_points, pose;
    std::vector<double> changes;
    int iterations = 0;
    for(int round = 0; round < number; ++round)
    {
      registrar.set_detail_length(of_measurement.detail_length);
      registrar.set_number_of_iterations(of_measurement.number_of_iterations);
      registrar.set_target(refined.points);
      measured = registrar.register_to_target(body_points);
      iterations += measured.iterations;
      if(round + 1 == number)
      {
        const Point_matrix start = body_points;
        registrar.set_detail_length(options.registration.detail_length);
        registrar.set_number_of_iterations(1);
        measured = registrar.register_to_target(body_points);
        body_points = (start + 1.25 * (body_points - start)).eval();
        iterations += measured.iterations;
      }
      pose = registrar.surface_points(body_points);
      fields_of_pose = CP::landmark_fields(coarse.posed(pose), fields.landmarks, options);
      const Point_matrix previous = refined.points;
      refined = CP::refined_target(surface, coarse, fields_of_pose, pose, options);
      const Point_matrix aligned = CP::align_target(refined.points, previous, shares);
      changes.push_back(std::sqrt(shares.dot((aligned - previous).rowwise().squaredNorm())));
    }
    const double stress = refined.summary.stress;
    if(number > 1)
    {
      const double factor
        = 0.6 * std::clamp((0.75 - changes[1] / changes[0]) / (0.75 - 0.6), 0., 1.);
      EXPECT_GT(factor, 0);
      const auto extrapolated
        = CP::extrapolated_fields(coarse, fields, fields_of_pose, pose, factor);
      refined = CP::refined_target(surface, coarse, extrapolated, pose, options);
    }
    const auto symmetry = CP::intrinsic_symmetry(coarse, fields_of_pose, refined.points);
    ASSERT_TRUE(symmetry);
    refined.points = CP::symmetric_target(coarse, *symmetry, refined.points);
    options.number_of_rounds = number;
    const auto result = CP::registered_pose(surface, coarse, fields, target, body, options);
    EXPECT_LT((*result.target - refined.points).rowwise().norm().maxCoeff(),
              1e-9 * body.length_scale);
    EXPECT_EQ(result.summary.target.stress, target.summary.stress);
    EXPECT_EQ(result.summary.target.kernel, target.summary.kernel);
    EXPECT_NEAR(result.summary.target.symmetry_distortion.value(), symmetry->distortion, 1e-9);
    EXPECT_GT(result.summary.iterations, iterations);
    ASSERT_EQ(result.summary.rounds.size(), std::size_t(number));
    EXPECT_NEAR(result.summary.rounds.back().stress, stress, 1e-9);
    EXPECT_NEAR(result.summary.rounds.back().energy, measured.energy, 1e-9 * measured.energy);
    EXPECT_NEAR(result.summary.rounds.back().median_edge_strain,
                CP::median_edge_strain(surface.points, pose, surface.triangles), 1e-9);

    // The registration starts at the measured pose, or at the target: two ways to the same minimum.
    options.number_of_rounds = 0;
    const auto expected = CP::registered_pose(surface, coarse, fields, refined, body, options);
    EXPECT_NEAR(result.summary.energy, expected.summary.energy, 0.01 * expected.summary.energy);
    EXPECT_LT((result.pose - expected.pose).rowwise().norm().maxCoeff(), 0.01 * body.length_scale);
  }
}

// Changes of distances that are common to a vertex or to a landmark are not extrapolated, nor is a change of size; the
// others are, in proportion to the factor, wherever distances remain positive. A landmark stays at distance 0.
TEST(Pose_steps, extrapolated_distances)
{
  const CP::Surface_component_3 surface = surface_of_bar();
  const auto coarse = CP::coarse_surface(surface);
  const auto options = coarse_options<CP::Component_options>();
  const auto fields = CP::landmark_fields(coarse, options);
  const Eigen::Index n = fields.distances.rows(), l = fields.distances.cols();
  const auto ramp
    = [](const Eigen::Index size) { return Eigen::VectorXd::LinSpaced(size, 0.1, 0.4).eval(); };
  const auto expect_near
    = [&](const CP::Landmark_fields_3& result, const Eigen::MatrixXd& expected) {
        ASSERT_EQ(result.landmarks, fields.landmarks);
        for(Eigen::Index j = 0; j < l; ++j)
          for(Eigen::Index i = 0; i < n; ++i)
            EXPECT_NEAR(result.distances(i, j),
                        std::size_t(i) == fields.landmarks[j] ? 0 : expected(i, j), 1e-12);
      };
  const double scale = 2;
  const Point_matrix pose = scale * surface.points;
  CP::Landmark_fields_3 of_pose = fields;
  of_pose.distances = scale * fields.distances;
  expect_near(CP::extrapolated_fields(coarse, fields, of_pose, pose, 3), of_pose.distances);
  of_pose.distances.colwise() += ramp(n);
  of_pose.distances.rowwise() += ramp(l).transpose();
  expect_near(CP::extrapolated_fields(coarse, fields, of_pose, pose, 3), of_pose.distances);
  const Eigen::VectorXd shares
    = CP::vertex_area_shares(coarse.surface.points, coarse.surface.triangles);
  Eigen::VectorXd of_vertices = ramp(n), of_landmarks = ramp(l);
  of_vertices.array() -= shares.dot(of_vertices);
  of_landmarks.array() -= of_landmarks.mean();
  const Eigen::MatrixXd product = of_vertices * of_landmarks.transpose(); // without common parts
  of_pose.distances += product;
  for(const double factor : {0., 0.5, 1.})
    expect_near(CP::extrapolated_fields(coarse, fields, of_pose, pose, factor),
                of_pose.distances + factor * product);
  of_pose.distances = fields.distances;
  of_pose.distances.array() *= 1 + 10 * product.array();
  EXPECT_EQ(CP::extrapolated_fields(coarse, fields, of_pose, pose, 100).distances.minCoeff(), 0);
}

// The other choice is the mirror image, whose handedness has the opposite numbers.
TEST(Pose_steps, mirror_image_of_the_target)
{
  const CP::Surface_component_3 surface = surface_of_bar();
  const auto coarse = CP::coarse_surface(surface);
  const auto fields = CP::landmark_fields(coarse);
  CP::Component_options options;
  const auto target = CP::mds_target(surface, coarse, fields, options);
  options.takes_mirror_image = true;
  const auto other = CP::mds_target(surface, coarse, fields, options);
  EXPECT_NE(other.summary.reflected, target.summary.reflected);
  const auto handedness = [&](const CP::Target_3& of) {
    return CP::target_handedness(of.points, surface.points, surface.triangles,
                                 CP::vertex_area_shares(surface.points, surface.triangles));
  };
  EXPECT_FALSE(handedness(target).is_mirror_image());
  EXPECT_TRUE(handedness(other).is_mirror_image());
  EXPECT_NEAR(handedness(other).volume_ratio, -handedness(target).volume_ratio, 1e-9);
  EXPECT_NEAR(handedness(other).chirality, -handedness(target).chirality, 1e-9);
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
  const auto& [surface, options] = prepared.components.front();
  const auto coarse = CP::coarse_surface(surface, options);
  const auto heat_fields = CP::landmark_fields(coarse, options);
  const auto path_fields = both.target_fields_function(surface.points, surface.triangles, 30,
                                                       heat_fields.landmarks[0], {});
  const auto target = CP::mds_target(surface, coarse, path_fields, options);
  const auto body = CP::surface_body(surface, coarse, heat_fields, options);
  EXPECT_EQ(body.length_scale, heat_fields.distances.maxCoeff());
  EXPECT_NE(body.length_scale, path_fields.distances.maxCoeff());
  for(const int rounds : {0, 1}) // in rounds, distances for a target are required only
  {
    both.number_of_rounds = heat.number_of_rounds = rounds;
    const CP::Result result = pose_of(shapes::bar(), both);
    EXPECT_EQ(result.pose, CP::registered_pose(surface, coarse, heat_fields, target, body,
                                               CP::Component_options{both, {}})
                             .pose);
    EXPECT_NE(result.pose, pose_of(shapes::bar(), heat).pose);
  }
}

// A target that is twice as large gives a pose of a larger volume. With a limit it is scaled down, by the power of the
// volume that suits the default detail length, so that the volume is near the limit.
TEST(Pose_steps, volume_of_a_given_target)
{
  CP::Options options;
  options.number_of_rounds = 0;
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
  CP::Component_options options = given_options;
  const auto coarse = CP::coarse_surface(surface, options);
  const auto fields = CP::landmark_fields(coarse, options);
  const auto target = CP::mds_target(surface, coarse, fields, options);
  const auto body = CP::surface_body(surface, coarse, fields, options);
  for(const double detail_length : {0.05, 0.2})
    for(const int rounds : {0, 1})
    {
      CP::Options whole;
      whole.registration.detail_length = options.registration.detail_length = detail_length;
      whole.number_of_rounds = options.number_of_rounds = rounds;
      EXPECT_EQ(CP::registered_pose(surface, coarse, fields, target, body, options).pose,
                pose_of(shapes::bar(), whole).pose);
    }
}

TEST(Pose_steps, what_does_not_fit_is_refused)
{
  const auto prepared
    = CP::prepare_surface(shapes::to_matrix(shapes::bar().points), shapes::bar().polygons);
  const auto& [surface, options] = prepared.components.front();
  EXPECT_THROW(CP::joined_result(prepared, {}), CGAL::Precondition_exception);
  const auto coarse = CP::coarse_surface(surface, options);
  auto fields = CP::landmark_fields(coarse, options);
  const auto target = CP::mds_target(surface, coarse, fields, options);
  const auto body = CP::surface_body(surface, coarse, fields, options);
  CP::Target_3 short_target = target;
  short_target.points.conservativeResize(5, 3);
  EXPECT_THROW(CP::registered_pose(surface, coarse, fields, short_target, body, options),
               CGAL::Precondition_exception);
  EXPECT_THROW(CP::refined_target(surface, coarse, fields, short_target.points, options),
               CGAL::Precondition_exception);
  EXPECT_THROW(coarse.posed(short_target.points), CGAL::Precondition_exception);
  CP::Coarse_surface_3 short_coarse = coarse;
  short_coarse.vertices.pop_back();
  EXPECT_THROW(CP::mds_target(surface, short_coarse, fields, options),
               CGAL::Precondition_exception);
  EXPECT_THROW(CP::surface_body(surface, short_coarse, fields, options),
               CGAL::Precondition_exception);
  EXPECT_THROW(CP::registered_pose(surface, short_coarse, fields, target, body, options),
               CGAL::Precondition_exception);
  fields.distances.conservativeResize(5, fields.distances.cols());
  EXPECT_THROW(CP::mds_target(surface, coarse, fields, options), CGAL::Precondition_exception);
  EXPECT_THROW(CP::surface_body(surface, coarse, fields, options), CGAL::Precondition_exception);
  EXPECT_THROW(CP::refined_target(surface, coarse, fields, target.points, options),
               CGAL::Precondition_exception);
  EXPECT_THROW_WITH(CP::prepare_surface(Point_matrix(), {}), std::invalid_argument, "no face");
}

} // namespace test_pose_steps
