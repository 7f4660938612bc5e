// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "matchers.h"
#include "shapes.h"
#include "threads.h"

namespace test_lattice_body {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

// A surface with the input of its lattice.
struct Prepared
{
  explicit Prepared(const shapes::Triangle_soup& soup)
  {
    CP::Point_matrix rows(static_cast<Eigen::Index>(soup.points.size()), 3);
    for(Eigen::Index i = 0; i < rows.rows(); ++i)
      for(Eigen::Index k = 0; k < 3; ++k)
        rows(i, k) = soup.points[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    surface = CP::repair_surface(rows, soup.triangles);
    const auto mesh = CP::internal::indexed_mesh(surface.points, surface.triangles);
    const CP::Heat_geodesics_3<CP::internal::Indexed_mesh> geodesics(mesh);
    distances = CP::farthest_point_landmarks(geodesics, 40, *vertices(mesh).begin()).distances;
  }

  CP::Lattice_body_3 body(const double spacing = 0) const
  {
    return CP::Lattice_body_3(surface.points, surface.triangles, distances, spacing, surface.caps);
  }

  CP::Repaired_surface_3 surface;
  Eigen::MatrixXd distances;
};

// Vertices - edges + triangles - cells of the body: 1 for a ball, 0 for a solid torus, 2 for a ball
// with a cavity, and the sum over separate parts.
long euler_characteristic(const CP::Lattice_body_3& body)
{
  std::set<std::array<int, 2>> edges;
  std::set<std::array<int, 3>> triangles;
  std::set<std::array<int, 4>> cells;
  for(std::array<int, 4> c : body.cells())
  {
    std::sort(c.begin(), c.end());
    cells.insert(c);
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = i + 1; j < 4; ++j)
      {
        edges.insert({c[i], c[j]});
        for(std::size_t k = j + 1; k < 4; ++k)
          triangles.insert({c[i], c[j], c[k]});
      }
  }
  return long(body.points().rows()) - long(edges.size()) + long(triangles.size())
         - long(cells.size());
}

// A box whose faces are grids of equal squares.
shapes::Triangle_soup box(const std::size_t n, const double height)
{
  return shapes::boundary(shapes::tetrahedral_box(n, n, 1, {{1., 1., height}}));
}

// Barycentric coordinates reproduce points up to rounding. They are between 0 and 1, because each
// vertex is embedded in the tetrahedron that contains it.
TEST(Lattice_body, surface_at_rest)
{
  const Prepared torus(shapes::torus_soup(60, 30, 1., 0.4));
  const CP::Lattice_body_3 body = torus.body();
  const double length = torus.distances.maxCoeff();
  EXPECT_LE((body.embedding() * body.points() - torus.surface.points).cwiseAbs().maxCoeff(),
            1e-13 * length);
  const Eigen::VectorXd sums = body.embedding() * Eigen::VectorXd::Ones(body.points().rows());
  EXPECT_LE((sums.array() - 1).abs().maxCoeff(), 1e-14);
  for(Eigen::Index k = 0; k < body.embedding().nonZeros(); ++k)
    EXPECT_GE(body.embedding().valuePtr()[k], 0);
  EXPECT_NEAR(body.cell_weights().sum(), 1, 1e-12);
  EXPECT_GT(body.cell_weights().minCoeff(), 0);
}

// Topology is exact: the solid and its body have the same Euler characteristic. The tube is bent by
// more than 360 degrees, so its ends intersect: it is still a ball if they are not glued. A thin
// plate that is torn into two sheets would be a shell (2).
TEST(Lattice_body, has_the_topology_of_the_solid)
{
  EXPECT_EQ(euler_characteristic(Prepared(shapes::icosphere_soup(4, 1.)).body()), 1);
  EXPECT_EQ(euler_characteristic(Prepared(shapes::torus_soup(80, 40, 1., 0.3)).body()), 0);
  EXPECT_EQ(euler_characteristic(Prepared(box(40, 1. / 200)).body()), 1);
  EXPECT_EQ(euler_characteristic(Prepared(box(40, 1. / 10)).body()), 1);

  shapes::Triangle_soup tube = shapes::tube_soup(120, 24, 10., 0.3);
  for(auto& p : tube.points)
    p = shapes::bend(p, 10., 7.);
  EXPECT_EQ(euler_characteristic(Prepared(tube).body()), 1);
}

// The filled parts of the cubes add up to the volume of the solid; 27 points per cube are accurate
// to 3 percent at these spacings. A half ball is open; its cap makes it a solid, up to one layer of cubes.
TEST(Lattice_body, volume)
{
  const double pi = std::acos(-1.);
  const double sphere = 4 * pi / 3;
  EXPECT_NEAR(Prepared(shapes::icosphere_soup(5, 1.)).body().volume() / sphere, 1, 0.03);
  EXPECT_NEAR(Prepared(shapes::torus_soup(120, 60, 1., 0.3)).body().volume() / (2 * pi * pi * 0.09),
              1, 0.03);
  shapes::Triangle_soup half = shapes::icosphere_soup(5, 1.);
  half.triangles.erase(std::remove_if(half.triangles.begin(), half.triangles.end(),
                                      [&](const auto& t) {
                                        return half.points[t[0]][2] < 0 || half.points[t[1]][2] < 0
                                               || half.points[t[2]][2] < 0;
                                      }),
                       half.triangles.end());
  const Prepared prepared(half);
  const CP::Lattice_body_3 body = prepared.body();
  const double layer = pi * body.spacing() * prepared.distances.maxCoeff();
  EXPECT_NEAR(body.volume(), sphere / 2, layer);
}

// Multiplying by a power of two is exact, and so are all results.
TEST(Lattice_body, follows_scaling)
{
  Prepared torus(shapes::torus_soup(60, 30, 1., 0.4));
  const CP::Lattice_body_3 body = torus.body();
  for(const double unit : {std::ldexp(1., -300), std::ldexp(1., 300)})
  {
    Prepared scaled = torus;
    scaled.surface.points *= unit;
    scaled.distances *= unit;
    const CP::Lattice_body_3 other = scaled.body();
    EXPECT_EQ(other.cells(), body.cells());
    EXPECT_EQ(other.points(), unit * body.points());
  }
}

TEST(Lattice_body, does_not_depend_on_the_number_of_threads)
{
  const Prepared torus(shapes::torus_soup(120, 60, 1., 0.4));
  const CP::Lattice_body_3 body = torus.body();
  Canonical_pose_test::with_each_number_of_threads([&] {
    const CP::Lattice_body_3 again = torus.body();
    EXPECT_EQ(again.cells(), body.cells());
    EXPECT_EQ(again.points(), body.points());
    EXPECT_EQ(again.cell_weights(), body.cell_weights());
  });
}

TEST(Lattice_body, names_bad_input)
{
  Prepared torus(shapes::torus_soup(30, 15, 1., 0.4));
  EXPECT_THROW_WITH(torus.body(-0.1), std::invalid_argument, "lattice_spacing is -0.1");
  EXPECT_THROW_WITH(torus.body(1e-6), std::invalid_argument, "too small");
  Prepared isolated = torus;
  isolated.surface.points.conservativeResize(451, 3);
  isolated.surface.points.row(450).setZero();
  isolated.distances.conservativeResize(451, Eigen::NoChange);
  isolated.distances.row(450).setZero();
  EXPECT_THROW_WITH(isolated.body(), std::invalid_argument, "vertex 450 belongs to no triangle");
  torus.distances(7, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW_WITH(torus.body(), std::invalid_argument, "not finite");
}

// Any affine motion of the nodes moves points near the surface in the same way, as barycentric
// coordinates reproduce affine functions; vertices of the surface keep their own row.
TEST(Body_deformer, reproduces_affine_motions_and_the_surface)
{
  const Prepared torus(shapes::torus_soup(60, 30, 1., 0.4));
  const CP::Lattice_body_3 body = torus.body();
  const CP::Body_deformer_3<CP::Lattice_body_3> deformer(body, torus.surface.triangles);
  Eigen::Matrix3d map;
  map << 1, 2, 0, 0.5, -1, 3, 0, 0.2, 1;
  const CP::Point_matrix points = 1.05 * torus.surface.points;
  EXPECT_LE(
    (deformer.embedding(points) * (body.points() * map) - points * map).cwiseAbs().maxCoeff(),
    1e-11);
  CP::Point_matrix moved = body.points();
  for(Eigen::Index i = 0; i < moved.rows(); ++i)
    moved(i, 0) += std::sin(3 * moved(i, 1)) + moved(i, 2) * moved(i, 2);
  EXPECT_LE((deformer.embedding(torus.surface.points) * moved - body.embedding() * moved)
              .cwiseAbs()
              .maxCoeff(),
            1e-12);
  CP::Point_matrix bad = CP::Point_matrix::Constant(1, 3, std::nan(""));
  EXPECT_THROW_WITH(deformer.embedding(bad), std::invalid_argument, "not finite");
}

} // namespace test_lattice_body
