// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic_fixtures.h"
#include "threads.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <type_traits>

namespace test_wavefront_geodesics {

using namespace Canonical_pose_test;
using Wavefront = CGAL::Canonical_pose_3::Wavefront_geodesics_3<Mesh>;
using Exact = CGAL::Canonical_pose_3::Exact_geodesics_3<Mesh>;

const double INF = std::numeric_limits<double>::infinity();

Eigen::VectorXd wavefront(const Triangle_soup& soup, std::size_t source)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  return Wavefront(mesh).distances(vertex(mesh, source));
}

double largest_relative_error(const Eigen::VectorXd& d, const Eigen::VectorXd& e)
{
  double largest = 0;
  for(Eigen::Index i = 0; i < d.size(); ++i)
    if(e[i] > 0)
      largest = (std::max)(largest, std::abs(d[i] - e[i]) / e[i]);
  return largest;
}

// In a convex planar region, the shortest path is the straight segment, through triangles of any
// shape: on the grid, with displaced vertices, and stretched 15 times.
TEST(Wavefront_geodesics, plane)
{
  for(const Triangle_soup& soup :
      {plane_grid_soup(30, 30, 3., 3.), stretched_square(30, 1.), stretched_square(30, 15.)})
    for(std::size_t source : {0, 17, 480, 960})
    {
      const Eigen::VectorXd e = straight_distances(soup.points, source);
      EXPECT_LT((wavefront(soup, source) - e).cwiseAbs().maxCoeff(), 1e-12 * e.maxCoeff());
    }
}

// The square of side 2 without its upper right quarter, whose vertices are isolated. From the lower
// arm, the path to a point behind the inner corner bends there; all others are straight.
TEST(Wavefront_geodesics, bend_at_a_reentrant_corner)
{
  Triangle_soup soup = plane_grid_soup(20, 20, 2., 2.);
  Triangles kept;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    if((f / 2) % 20 < 10 || f / 40 < 10)
      kept.push_back(soup.triangles[f]);
  soup.triangles = kept;
  for(std::size_t source : {20, 14, 57, 220}) // (2,0), (1.4,0), (1.5,0.2), (1,1)
  {
    const double x = soup.points[source][0], y = soup.points[source][1];
    const Eigen::VectorXd d = wavefront(soup, source), e = straight_distances(soup.points, source);
    for(std::size_t i = 0; i < soup.points.size(); ++i)
    {
      const double u = soup.points[i][0], v = soup.points[i][1];
      const bool is_hidden
        = x > 1.001 && u < 1.001 && v > 1.001 && y + (v - y) * (x - 1.) / (x - u) > 1.;
      const double expected = u > 1.001 && v > 1.001 ? INF
                              : is_hidden ? std::hypot(x - 1., y - 1.) + std::hypot(u - 1., v - 1.)
                                          : e[static_cast<Eigen::Index>(i)];
      if(expected == INF)
        EXPECT_EQ(d[static_cast<Eigen::Index>(i)], INF);
      else
        EXPECT_NEAR(d[static_cast<Eigen::Index>(i)], expected, 1e-12) << source << " to " << i;
    }
  }
}

// The faceted cylinder unrolls into a rectangle; a path may run around it in either direction: the
// distance is the shorter of the two straight segments. It is exact, since all interior vertices
// are flat.
TEST(Wavefront_geodesics, cylinder)
{
  const std::size_t sides = 24, rings = 30;
  Triangle_soup soup = tube_soup(rings, sides, 4., 1.);
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(),
                                      [&](const auto& t) { return t[0] >= rings * sides; }),
                       soup.triangles.end());
  const Eigen::VectorXd d = wavefront(soup, 0);
  const double side = 2. * std::sin(pi / double(sides));
  for(std::size_t i = 0; i < rings; ++i)
    for(std::size_t j = 0; j < sides; ++j)
      EXPECT_NEAR(
        d[static_cast<Eigen::Index>(i * sides + j)],
        std::hypot(4. * double(i) / double(rings - 1), side * double((std::min)(j, sides - j))),
        1e-12);
}

// On the sphere, the distance is the angle. When edges are halved, the distance of the faces to the
// sphere is quartered, and so is the error of shortest paths on them.
TEST(Wavefront_geodesics, refined_spheres)
{
  double last = 1;
  for(unsigned int k : {2u, 3u, 4u, 5u})
  {
    const Triangle_soup soup = icosphere_soup(k, 1.);
    const Eigen::VectorXd chords = straight_distances(soup.points, 7) / 2.;
    const Eigen::VectorXd arcs = 2. * chords.cwiseMin(1.).array().asin().matrix();
    const double error = mean_relative_error(wavefront(soup, 7), arcs);
    EXPECT_LT(error, last / 3.5) << k;
    last = error;
  }
}

// Every distance is the length of a path: never less than that of the shortest path. The mean and
// the largest excess are bounded, on shapes with long thin faces, with strong curvature, and on
// thin and long shapes.
TEST(Wavefront_geodesics, close_to_exact_paths_from_above)
{
  const double mean_bound = 2.5e-3, worst_bound = 0.03;
  for(const Mesh& mesh :
      {tube<Mesh>(60, 16, 6., 0.4, 2.5), torus<Mesh>(40, 20, 2., 0.7), torus<Mesh>(100, 6, 2., 0.7),
       icosphere<Mesh>(3, 1.), curled_strip<Mesh>(60, 15, 5.), bent_bar<Mesh>(24, 4, 4, 3.),
       bar<Mesh>(8, 8, 8, {{1., 1., 1.}}), tube<Mesh>(300, 3, 100., 0.2), strip<Mesh>(400, 2),
       tube<Mesh>(20, 40, 20., 0.5), to_mesh<Mesh>(stretched_square(20, 15.))})
  {
    const Wavefront wavefront(mesh);
    const Exact exact(mesh);
    for(std::size_t i : {std::size_t(0), std::size_t(num_vertices(mesh)) / 3})
    {
      const Eigen::VectorXd d = wavefront.distances(vertex(mesh, i)),
                            e = exact.distances(vertex(mesh, i));
      EXPECT_GE((d - e).minCoeff(), -1e-9 * e.maxCoeff());
      EXPECT_LT(mean_relative_error(d, e), mean_bound) << num_vertices(mesh);
      EXPECT_LT(largest_relative_error(d, e), worst_bound) << num_vertices(mesh);
    }
  }
}

// A grid with random heights and one with random holes, the same on every machine. Ears and corners
// that no beam enters are reached along edges. A source that sees a vertex on both sides of a hole
// is assumed to see everything in between: the only case in which a distance may be slightly too
// short.
TEST(Wavefront_geodesics, rough_and_perforated)
{
  unsigned int state = 7;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) / 4294967296.; };
  Triangle_soup rough = plane_grid_soup(20, 20, 1., 1.), perforated = stretched_square(20, 1.);
  for(auto& p : rough.points)
    p[2] = 0.2 * random();
  Triangles kept;
  std::vector<bool> is_used(perforated.points.size(), false);
  for(const auto& t : perforated.triangles)
    if(random() < 0.1 && !is_used[t[0]] && !is_used[t[1]] && !is_used[t[2]])
      is_used[t[0]] = is_used[t[1]] = is_used[t[2]] = true;
    else
      kept.push_back(t);
  perforated.triangles = kept;
  for(const Triangle_soup& soup : {rough, perforated})
  {
    const Mesh mesh = to_mesh<Mesh>(soup);
    for(std::size_t i : {0, 11, 148, 285, 422})
    {
      const Eigen::VectorXd d = Wavefront(mesh).distances(vertex(mesh, i)),
                            e = Exact(mesh).distances(vertex(mesh, i));
      ASSERT_TRUE((d.array().isFinite() == e.array().isFinite()).all());
      const Eigen::VectorXd excess
        = e.array().isFinite().select((d - e).array(), Eigen::ArrayXd::Zero(d.size()));
      const double largest = e.array().isFinite().select(e.array(), 0.).maxCoeff();
      EXPECT_GE(excess.minCoeff(), -0.005 * largest);
      EXPECT_LT(excess.cwiseAbs().maxCoeff(), 0.03 * largest);
      EXPECT_LT(excess.cwiseAbs().mean(), 1e-3 * largest);
    }
  }
}

// Shortest paths are symmetric, but the paths found are only nearly so: the bound is on the
// asymmetry of the worst pair relative to the largest distance.
TEST(Wavefront_geodesics, nearly_symmetric)
{
  const Mesh mesh = torus<Mesh>(60, 24, 2., 0.8);
  std::vector<Mesh::Vertex_index> sources;
  for(std::size_t i = 0; i < 1440; i += 37)
    sources.push_back(vertex(mesh, i));
  const Eigen::MatrixXd d = Wavefront(mesh).distances(sources);
  Eigen::MatrixXd between(d.cols(), d.cols());
  for(Eigen::Index i = 0; i < d.cols(); ++i)
    between.row(i) = d.row(37 * i);
  EXPECT_LT((between - between.transpose()).cwiseAbs().maxCoeff(), 2e-3 * d.maxCoeff());
}

// Lengths are normalized by a power of two: such a scale changes no mantissa, any other scale only
// causes rounding.
TEST(Wavefront_geodesics, any_unit)
{
  const Triangle_soup soup = torus_soup(40, 20, 2., 0.7);
  const auto distances = [&](double scale) {
    const auto scaled = [&](std::array<double, 3> p) {
      return std::array<double, 3>{{scale * p[0], scale * p[1], scale * p[2]}};
    };
    return wavefront({transformed(soup.points, scaled), soup.triangles}, 3);
  };
  const Eigen::VectorXd d = distances(1.);
  for(int exponent : {-900, -20, 3, 900})
    EXPECT_EQ(distances(std::ldexp(1., exponent)), d * std::ldexp(1., exponent));
  for(double scale : {1e-200, 1e-6, 1e6, 1e200})
    EXPECT_LT((distances(scale) / scale - d).cwiseAbs().maxCoeff(), 1e-3 * d.maxCoeff()) << scale;
}

// Relabeling vertices and faces may break ties differently, which changes distances within their
// error; on this shape, nothing else changes.
TEST(Wavefront_geodesics, relabeled)
{
  const Triangle_soup soup = tube_soup(40, 16, 6., 0.4);
  const std::size_t n = soup.points.size();
  Triangle_soup other = soup;
  for(std::size_t i = 0; i < n; ++i)
    other.points[n - 1 - i] = soup.points[i];
  std::reverse(other.triangles.begin(), other.triangles.end());
  for(auto& t : other.triangles)
    t = {{n - 1 - t[1], n - 1 - t[2], n - 1 - t[0]}};
  const Eigen::VectorXd d = wavefront(soup, 5), e = wavefront(other, n - 6).reverse();
  EXPECT_LT((d - e).cwiseAbs().maxCoeff(), 2e-3 * d.maxCoeff());
}

// A column of a batch is bitwise equal to its single query.
TEST(Wavefront_geodesics, batch_is_single_queries)
{
  const Mesh mesh = icosphere<Mesh>(3, 1.);
  const Wavefront wavefront(mesh);
  const std::vector<Mesh::Vertex_index> sources = sources_on_ball(mesh);
  const Eigen::MatrixXd batch = wavefront.distances(sources);
  for(std::size_t k = 0; k < sources.size(); ++k)
    EXPECT_EQ(batch.col(static_cast<Eigen::Index>(k)), wavefront.distances(sources[k])) << k;
  EXPECT_EQ(wavefront.distances(std::vector<Mesh::Vertex_index>()).cols(), 0);
}

TEST(Wavefront_geodesics, number_of_threads_does_not_matter)
{
  const Mesh mesh = icosphere<Mesh>(3, 1.);
  const std::vector<Mesh::Vertex_index> sources = sources_on_ball(mesh);
  const Eigen::MatrixXd batch = Wavefront(mesh).distances(sources);
  with_each_number_of_threads([&] { EXPECT_EQ(Wavefront(mesh).distances(sources), batch); });
}

// The nearest of several sources: in the plane, the smallest of the Euclidean distances, exactly.
TEST(Wavefront_geodesics, nearest_source)
{
  const Triangle_soup soup = stretched_square(30, 3.);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Wavefront wavefront(mesh);
  std::vector<Mesh::Vertex_index> sources;
  Eigen::VectorXd e = Eigen::VectorXd::Constant(961, INF);
  for(int i : {0, 500, 499, 931, 0})
  {
    sources.push_back(vertex(mesh, static_cast<std::size_t>(i)));
    e = e.cwiseMin(straight_distances(soup.points, static_cast<std::size_t>(i)));
  }
  EXPECT_LT((wavefront.distance_to_nearest(sources) - e).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(wavefront.distance_to_nearest(std::vector<Mesh::Vertex_index>()).minCoeff(), INF);
}

// The coordinates of all these meshes are the same numbers, which float represents exactly.
TEST(Wavefront_geodesics, any_mesh_kernel_and_map)
{
  Triangle_soup soup = torus_soup(20, 12, 2., 0.7);
  for(auto& p : soup.points)
    for(double& x : p)
      x = static_cast<float>(x);
  const auto distances = [&](const auto& mesh) {
    using Any_mesh = std::decay_t<decltype(mesh)>;
    return CGAL::Canonical_pose_3::Wavefront_geodesics_3<Any_mesh>(mesh).distances(vertex(mesh, 5));
  };
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Eigen::VectorXd d = distances(mesh);
  EXPECT_EQ(distances(to_mesh<CGAL::Polyhedron_3<Kernel>>(soup)), d);
  EXPECT_EQ(distances(to_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(soup)),
            d);

  using Map = std::map<Mesh::Vertex_index, archetype::Point>;
  using Point_map = boost::const_associative_property_map<Map>;
  Map points;
  for(auto v : mesh.vertices())
    points.emplace(v, archetype::Traits().construct_point_3_object()(
                        mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  const CGAL::Canonical_pose_3::Wavefront_geodesics_3<Mesh, Point_map, archetype::Traits> own(
    mesh, Point_map(points));
  EXPECT_EQ(own.distances(vertex(mesh, 5)), d);
  std::map<Mesh::Vertex_index, float> written;
  own.distances(vertex(mesh, 5), boost::make_assoc_property_map(written));
  for(auto v : mesh.vertices())
    EXPECT_EQ(written[v], static_cast<float>(d[static_cast<Eigen::Index>(own.index(v))]));
}

// One face has two legs of length 1 and no edge to cross.
TEST(Wavefront_geodesics, one_triangle)
{
  const Mesh mesh = to_mesh<Mesh>({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}});
  const Eigen::VectorXd d = Wavefront(mesh).distances(vertex(mesh, 0));
  EXPECT_EQ(d, Eigen::Vector3d(0., 1., 1.));
}

} // namespace test_wavefront_geodesics
