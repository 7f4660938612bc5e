// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"
#include "threads.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace test_heat_geodesics {

using namespace Canonical_pose_test;
using Heat = CGAL::Canonical_pose_3::Heat_geodesics_3<Mesh>;
using Exact = CGAL::Canonical_pose_3::Exact_geodesics_3<Mesh>;

// The heat method is consistent, not exact: on a quasi-uniform mesh, the mean relative error is a
// few percent, mostly due to smoothing next to the source and at the cut locus.
const double HEAT_TOLERANCE = 0.03;

// In the plane, distances are Euclidean. The least squares factor between the two detects a wrong
// constant (typically 2) even if single errors are large.
TEST(Heat_geodesics, absolute_scale_in_the_plane)
{
  const Triangle_soup soup = plane_grid_soup(50, 50, 3., 3.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const std::size_t center = 25 * 51 + 25;
  const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, center));
  const Eigen::VectorXd e = straight_distances(soup.points, center);
  EXPECT_LT(mean_relative_error(d, e), HEAT_TOLERANCE);
  EXPECT_NEAR(d.dot(e) / e.squaredNorm(), 1., 0.01);
}

// On the sphere, the distance is the angle times the radius.
TEST(Heat_geodesics, great_circles)
{
  const Triangle_soup soup = icosphere_soup(4, 5.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::VectorXd chords = straight_distances(soup.points, 7) / 10.;
  const Eigen::VectorXd arcs = 10. * chords.cwiseMin(1.).array().asin().matrix();
  const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, 7));
  EXPECT_LT(mean_relative_error(d, arcs), HEAT_TOLERANCE);
  EXPECT_NEAR(d.maxCoeff(), arcs.maxCoeff(), HEAT_TOLERANCE * arcs.maxCoeff());
  EXPECT_EQ(d[7], 0.);
  EXPECT_GE(d.minCoeff(), 0.);
}

// The lengths are normalized by a power of two: such a scale changes no mantissa. Any other scale
// rounds the coordinates, and may flip cocircular edges differently, which changes nothing either.
TEST(Heat_geodesics, any_unit)
{
  const Triangle_soup soup = torus_soup(40, 20, 2., 0.7);
  const auto distances = [&](double scale) {
    const auto scaled = [&](std::array<double, 3> p) {
      return std::array<double, 3>{{scale * p[0], scale * p[1], scale * p[2]}};
    };
    const Mesh mesh = to_mesh<Mesh>(transformed(soup.points, scaled), soup.triangles);
    return Heat(mesh).distances(vertex(mesh, 3));
  };
  const Eigen::VectorXd d = distances(1.);
  for(int exponent : {-900, -20, 3, 900})
    EXPECT_EQ(distances(std::ldexp(1., exponent)), d * std::ldexp(1., exponent));
  for(double scale : {1e-300, 1e-150, 1e-6, 1e6, 1e150, 1e300})
    EXPECT_LT((distances(scale) / scale - d).cwiseAbs().maxCoeff(), 1e-10 * d.maxCoeff()) << scale;
}

// Distances are symmetric, but those of the heat method only nearly so: the bound is on the
// asymmetry of the worst pair relative to the largest distance.
TEST(Heat_geodesics, nearly_symmetric)
{
  const double asymmetry_bound = 0.04;
  const Mesh mesh = torus<Mesh>(60, 24, 2., 0.8);
  std::vector<Mesh::Vertex_index> sources;
  for(std::size_t i = 0; i < 1440; i += 37)
    sources.push_back(vertex(mesh, i));
  const Eigen::MatrixXd d = Heat(mesh).distances(sources);
  Eigen::MatrixXd between(d.cols(), d.cols());
  for(Eigen::Index i = 0; i < d.cols(); ++i)
    between.row(i) = d.row(37 * i);
  EXPECT_LT((between - between.transpose()).cwiseAbs().maxCoeff(), asymmetry_bound * d.maxCoeff());
}

// With the squared edge length as time step, the heat at the far end would be exp(-4000), which is
// 0 in double precision. The strip is flat, so the distance to the other end is its length; the
// wire is compared to its straight tube.
TEST(Heat_geodesics, far_field)
{
  const std::size_t n = 4000;
  const Mesh strip_mesh = strip<Mesh>(n, 2);
  const Eigen::VectorXd d = Heat(strip_mesh).distances(vertex(strip_mesh, 0));
  for(std::size_t i : {n / 4, n / 2, n})
    EXPECT_NEAR(d[static_cast<Eigen::Index>(i)], double(i), 0.01 * double(n));
  for(std::size_t i = 20; i + 20 < n; ++i)
    ASSERT_NEAR(d[static_cast<Eigen::Index>(i + 1)] - d[static_cast<Eigen::Index>(i)], 1., 0.05)
      << i;

  const Mesh wire = tube<Mesh>(3000, 3, 1000., 0.2);
  const Eigen::VectorXd w = Heat(wire).distances(vertex(wire, 0));
  EXPECT_NEAR(w[3 * 2999], 1000., 10.);
}

// Exact shortest paths are the reference; the surface is curved, closed, and has two scales.
TEST(Heat_geodesics, agrees_with_exact_paths)
{
  const Mesh mesh = tube<Mesh>(60, 16, 6., 0.4, 2.5);
  const Heat heat(mesh);
  const Exact exact(mesh);
  for(std::size_t i : {std::size_t(0), std::size_t(333)})
    EXPECT_LT(
      mean_relative_error(heat.distances(vertex(mesh, i)), exact.distances(vertex(mesh, i))), 0.06);
}

// Stretched 10 times, the mean error of the heat method on the triangles as given is 31 %; after
// the intrinsic flips they are as good as the vertices allow, and it is 2.3 %.
TEST(Heat_geodesics, stretched_triangles)
{
  const Triangle_soup soup = stretched_square(40, 10.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, 0));
  EXPECT_LT(mean_relative_error(d, straight_distances(soup.points, 0)), HEAT_TOLERANCE);
}

// A column of a batch is bitwise equal to its single query.
TEST(Heat_geodesics, batch_is_single_queries)
{
  const Mesh mesh = icosphere<Mesh>(3, 1.);
  const Heat heat(mesh);
  const std::vector<Mesh::Vertex_index> sources = sources_on_ball(mesh);
  const Eigen::MatrixXd batch = heat.distances(sources);
  for(std::size_t k = 0; k < sources.size(); ++k)
    EXPECT_EQ(batch.col(static_cast<Eigen::Index>(k)), heat.distances(sources[k])) << k;
  EXPECT_EQ(heat.distances(std::vector<Mesh::Vertex_index>()).cols(), 0);
}

// Factorization and solves, of a batch and of the nearest of several sources.
TEST(Heat_geodesics, number_of_threads_does_not_matter)
{
  const Mesh mesh = icosphere<Mesh>(3, 1.);
  const std::vector<Mesh::Vertex_index> sources = sources_on_ball(mesh);
  const Eigen::MatrixXd batch = Heat(mesh).distances(sources);
  with_each_number_of_threads([&] {
    const Heat heat(mesh);
    EXPECT_EQ(heat.distances(sources), batch);
    EXPECT_EQ(heat.distance_to_nearest(sources), Eigen::VectorXd(batch.rowwise().minCoeff()));
  });
}

// The distance from several sources is the smallest of their distances, by definition and thus bit
// by bit. The reference is the plane, where distances are Euclidean.
TEST(Heat_geodesics, distance_to_nearest)
{
  const Triangle_soup soup = plane_grid_soup(40, 40, 1., 1.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Heat heat(mesh);
  std::vector<Mesh::Vertex_index> sources;
  Eigen::VectorXd straight = straight_distances(soup.points, 5);
  for(std::size_t i : {5u, 410u, 830u, 1200u, 1680u, 777u, 60u, 1333u, 900u, 901u, 5u})
  {
    sources.push_back(vertex(mesh, i));
    straight = straight.cwiseMin(straight_distances(soup.points, i));
  }
  const Eigen::VectorXd d = heat.distance_to_nearest(sources);
  EXPECT_EQ(d, Eigen::VectorXd(heat.distances(sources).rowwise().minCoeff()));
  EXPECT_LT(mean_relative_error(d, straight), 0.05); // many vertices are only a few edges away
  for(Mesh::Vertex_index source : sources)
    EXPECT_EQ(d[static_cast<Eigen::Index>(source.idx())], 0.);
  EXPECT_EQ(heat.distance_to_nearest(std::vector<Mesh::Vertex_index>{sources[1]}),
            heat.distances(sources[1]));
  EXPECT_EQ(heat.distance_to_nearest(std::vector<Mesh::Vertex_index>()).minCoeff(),
            std::numeric_limits<double>::infinity());
}

// In flat convex regions, the distance is Euclidean, even if the heat would underflow with the mean
// edge length: across 850 edges, and along 2000.
TEST(Heat_geodesics, fine_and_long_pieces_of_the_plane)
{
  for(const auto& [columns, rows] : {std::make_pair(600, 600), std::make_pair(2000, 6)})
  {
    const Triangle_soup soup
      = plane_grid_soup(std::size_t(columns), std::size_t(rows), double(columns), double(rows));
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, 0));
    EXPECT_LT(mean_relative_error(d, straight_distances(soup.points, 0)), HEAT_TOLERANCE)
      << columns;
  }
}

TEST(Heat_geodesics_time_step, default_factor_is_1)
{
  const Mesh mesh = torus<Mesh>(40, 20, 2., 0.7);
  const auto source = vertex(mesh, 3);
  const Eigen::VectorXd d = Heat(mesh).distances(source);
  EXPECT_EQ(Heat(mesh, 1.).distances(source), d);
  EXPECT_EQ(Heat(mesh, mesh.points(), Kernel(), 1.).distances(source), d);
  EXPECT_NE(Heat(mesh, 2.).distances(source), d);
}

// From the center of its cap, heat flows straight along a tube whatever the step: distances between the
// rings are exact. Without its lower bound the shortest step would leave no heat there; with the longest
// the heat is nearly even.
TEST(Heat_geodesics_time_step, straight_along_a_tube)
{
  const std::size_t rings = 500, sides = 12;
  const Mesh mesh = tube<Mesh>(rings, sides, 100., 0.2);
  for(double factor : {std::numeric_limits<double>::denorm_min(), 0.1, 1., 10., 1e6})
  {
    const Eigen::VectorXd d = Heat(mesh, factor).distances(vertex(mesh, rings * sides));
    for(std::size_t i = 0; i < rings; ++i)
      ASSERT_NEAR(d[static_cast<Eigen::Index>(i * sides)] - d[0],
                  100. * double(i) / double(rings - 1), 1e-4)
        << factor << ", " << i;
  }
}

// On a flat convex surface distances are Euclidean. The step, and with it the error, goes to 0 with the
// edge length for any factor that is not much less than 1. Long steps err by the boundary, which bends
// the heat; the longest, by 18 percent on any of these meshes.
TEST(Heat_geodesics_time_step, converges_in_the_plane)
{
  const auto error = [](std::size_t n, double factor) {
    const Triangle_soup soup = plane_grid_soup(n, n, 1., 1.);
    const Mesh mesh = to_mesh<Mesh>(soup);
    const std::size_t source = (n / 4) * (n + 2);
    return mean_relative_error(Heat(mesh, factor).distances(vertex(mesh, source)),
                               straight_distances(soup.points, source));
  };
  for(double factor : {1., 4., 16.})
  {
    EXPECT_LT(error(40, factor), 0.8 * error(20, factor)) << factor;
    EXPECT_LT(error(80, factor), 0.9 * error(40, factor)) << factor;
  }
  EXPECT_LT(error(80, 1.), 0.015);
  EXPECT_LT(error(80, 4.), 0.015);
  EXPECT_GT(error(80, 16.), 2 * error(80, 4.));
  EXPECT_GT(error(80, 1e6), 0.15);
}

// Where shortest paths around a torus meet, the slope of the distance jumps; the jump is spread over a
// width that grows with the step.
TEST(Heat_geodesics_time_step, longer_steps_smooth)
{
  const Eigen::Index sides = 60;
  const Mesh mesh = torus<Mesh>(120, std::size_t(sides), 2., 0.8);
  double before = std::numeric_limits<double>::infinity();
  for(double factor : {0.25, 1., 4., 16., 64.})
  {
    const Eigen::VectorXd d = Heat(mesh, factor).distances(vertex(mesh, 0));
    double kink = 0;
    for(Eigen::Index i = 15 * sides + sides / 2; i < 45 * sides; i += sides)
      kink = std::max(kink, std::abs(d[i - 1] - 2 * d[i] + d[i + 1]));
    EXPECT_LT(kink, 0.8 * before) << factor;
    before = kink;
  }
}

// Vertices that lie 20 times denser in one direction than in the other.
TEST(Heat_geodesics_time_step, longer_steps_reach_across_gaps)
{
  const Triangle_soup soup = stretched_square(40, 20.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const auto error = [&](double factor) {
    return mean_relative_error(Heat(mesh, factor).distances(vertex(mesh, 0)),
                               straight_distances(soup.points, 0));
  };
  EXPECT_GT(error(1.), 0.3);
  EXPECT_LT(error(4.), 0.02);
}

// The coordinates of all these meshes are the same numbers, which float represents exactly.
TEST(Heat_geodesics, any_mesh_and_kernel)
{
  Triangle_soup soup = torus_soup(20, 12, 2., 0.7);
  for(auto& p : soup.points)
    for(double& x : p)
      x = static_cast<float>(x);
  const auto distances = [&](const auto& mesh) {
    using Any_mesh = std::decay_t<decltype(mesh)>;
    return CGAL::Canonical_pose_3::Heat_geodesics_3<Any_mesh>(mesh).distances(vertex(mesh, 5));
  };
  const Eigen::VectorXd d = distances(to_mesh<Mesh>(soup));
  EXPECT_EQ(distances(to_mesh<CGAL::Polyhedron_3<Kernel>>(soup)), d);
  EXPECT_EQ(distances(to_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(soup)),
            d);
  EXPECT_EQ(distances(to_mesh<CGAL::Surface_mesh<CGAL::Epeck::Point_3>>(soup)), d);
}

TEST(Heat_geodesics, time_step_factors_out_of_bounds)
{
  const Mesh mesh = icosphere<Mesh>(1, 1.);
  const double inf = std::numeric_limits<double>::infinity();
  const auto said = [&](double factor) {
    return message_of<std::invalid_argument>([&] { Heat(mesh, mesh.points(), Kernel(), factor); });
  };
  for(double factor : {0., -1., -inf, inf, std::numeric_limits<double>::quiet_NaN(), 1.1e6})
  {
    EXPECT_NE(said(factor).find("the time step factor is "), std::string::npos) << factor;
    EXPECT_EQ(message_of<std::invalid_argument>([&] { Heat(mesh, factor); }), said(factor));
  }
  EXPECT_EQ(said(-1.), "the time step factor is -1, not positive and at most 1e6");
  for(double factor : {std::numeric_limits<double>::denorm_min(), 1e6})
    EXPECT_EQ(said(factor), "nothing");
}

// On a right triangle with legs 1 there is one face, no inner edge, and the gradient of the heat is
// constant: the distance is a linear function that is 0 at the source and equal at the two others,
// hence 1/sqrt(2).
TEST(Heat_geodesics, one_triangle)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}});
  const Eigen::VectorXd d = Heat(mesh).distances(vertex(mesh, 0));
  EXPECT_EQ(d[0], 0.);
  EXPECT_NEAR(d[1], std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(d[2], std::sqrt(0.5), 1e-14);
}

} // namespace test_heat_geodesics
