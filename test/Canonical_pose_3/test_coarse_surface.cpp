// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <gtest/gtest.h>

#include "dirty_shapes.h"
#include "matchers.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_coarse_surface {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Coarse_surface_3;
using CP::Point_matrix;
using CP::Surface_component_3;
using shapes::Triangle_soup;
using Indices = std::vector<std::size_t>;

// Faces and vertices of the input differ from those of the component.
Surface_component_3 component(const Triangle_soup& soup)
{
  Surface_component_3 result;
  result.points = shapes::to_matrix(soup.points);
  result.triangles = soup.triangles;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    result.face_of_triangle.push_back(3 * f + 1);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    result.origins.push_back(2 * v + 5);
  result.body_origins = result.origins;
  return result;
}

struct Topology
{
  std::ptrdiff_t euler_characteristic;
  std::size_t boundary_loops;

  friend bool operator==(const Topology& a, const Topology& b)
  {
    return a.euler_characteristic == b.euler_characteristic && a.boundary_loops == b.boundary_loops;
  }
};

// Fails unless the surface is an oriented 2-manifold without isolated vertices.
Topology topology(const Surface_component_3& surface)
{
  EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(surface.triangles));
  std::set<std::pair<std::size_t, std::size_t>> sides;
  std::set<std::size_t> vertices;
  for(const auto& t : surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
    {
      vertices.insert(t[k]);
      EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
    }
  EXPECT_EQ(vertices.size(), static_cast<std::size_t>(surface.points.rows()));
  std::map<std::size_t, std::size_t> next_on_boundary;
  for(const auto& side : sides)
    if(sides.count({side.second, side.first}) == 0)
      next_on_boundary.insert(side);
  const std::size_t edges = (sides.size() + next_on_boundary.size()) / 2;
  Topology result{
    std::ptrdiff_t(vertices.size() + surface.triangles.size()) - std::ptrdiff_t(edges), 0};
  for(; !next_on_boundary.empty(); ++result.boundary_loops)
    for(std::size_t v = next_on_boundary.begin()->first; next_on_boundary.count(v) > 0;)
    {
      const std::size_t next = next_on_boundary[v];
      next_on_boundary.erase(v);
      v = next;
    }
  return result;
}

// Guarantees of the documentation.
void expect_valid(const Coarse_surface_3& coarse, const Surface_component_3& surface)
{
  const auto n = static_cast<std::size_t>(surface.points.rows());
  EXPECT_EQ(coarse.number_of_surface_vertices(), n);
  ASSERT_EQ(static_cast<std::size_t>(coarse.surface.points.rows()), coarse.vertices.size());
  ASSERT_EQ(coarse.surface.origins.size(), coarse.vertices.size());
  std::vector<bool> is_known(n, false);
  for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
  {
    const std::size_t v = coarse.vertices[i];
    ASSERT_LT(v, n);
    EXPECT_TRUE(i == 0 || coarse.vertices[i - 1] < v);
    EXPECT_EQ(coarse.surface.points.row(Eigen::Index(i)), surface.points.row(Eigen::Index(v)));
    EXPECT_EQ(coarse.surface.origins[i], surface.origins[v]);
    is_known[v] = true;
  }
  for(const auto& [vertex, others, weights] : coarse.combinations)
  {
    EXPECT_FALSE(is_known.at(vertex));
    for(std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(is_known.at(others[k]));
      EXPECT_GE(weights[k], 0.);
    }
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1., 1e-15);
    is_known[vertex] = true;
  }
  EXPECT_EQ(is_known, std::vector<bool>(n, true));

  Indices faces = coarse.surface.face_of_triangle;
  EXPECT_EQ(faces.size(), coarse.surface.triangles.size());
  std::sort(faces.begin(), faces.end());
  EXPECT_EQ(std::adjacent_find(faces.begin(), faces.end()), faces.end());
  EXPECT_TRUE(std::includes(surface.face_of_triangle.begin(), surface.face_of_triangle.end(),
                            faces.begin(), faces.end()));
  EXPECT_TRUE(coarse.surface.caps.empty());
}

void expect_same(const Coarse_surface_3& a, const Coarse_surface_3& b)
{
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.surface.triangles, b.surface.triangles);
  EXPECT_EQ(a.surface.face_of_triangle, b.surface.face_of_triangle);
  ASSERT_EQ(a.combinations.size(), b.combinations.size());
  for(std::size_t i = 0; i < a.combinations.size(); ++i)
  {
    EXPECT_EQ(a.combinations[i].vertex, b.combinations[i].vertex);
    EXPECT_EQ(a.combinations[i].vertices, b.combinations[i].vertices);
    EXPECT_EQ(a.combinations[i].weights, b.combinations[i].weights);
  }
}

// Twice the area of a triangle, as a vector in the direction of its normal.
Eigen::RowVector3d normal(const Surface_component_3& surface, const std::size_t f)
{
  const auto point = [&](const std::size_t k) -> Eigen::RowVector3d {
    return surface.points.row(Eigen::Index(surface.triangles[f][k]));
  };
  return (point(1) - point(0)).cross(point(2) - point(0));
}

double area(const Surface_component_3& surface)
{
  double result = 0;
  for(std::size_t f = 0; f < surface.triangles.size(); ++f)
    result += normal(surface, f).norm() / 2;
  return result;
}

Triangle_soup without_faces(Triangle_soup soup, const std::set<std::size_t>& faces)
{
  shapes::Triangles others;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    if(faces.count(f) == 0)
      others.push_back(soup.triangles[f]);
  soup.triangles.swap(others);
  return soup;
}

// Without the two centers of the ends.
Triangle_soup open_tube(const std::size_t rings, const std::size_t sides)
{
  Triangle_soup soup = shapes::tube_soup(rings, sides, 8., 0.5);
  const std::size_t n = rings * sides;
  soup.points.resize(n);
  std::set<std::size_t> ends;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    if(*std::max_element(soup.triangles[f].begin(), soup.triangles[f].end()) >= n)
      ends.insert(f);
  return without_faces(soup, ends);
}

Triangle_soup bent(Triangle_soup soup, const double length, const double angle)
{
  soup.points = shapes::transformed(soup.points,
                                    [&](const auto& p) { return shapes::bend(p, length, angle); });
  return soup;
}

// With vertices in random order and moved by up to a given length in each coordinate.
Triangle_soup irregular(const Triangle_soup& soup, const double length)
{
  std::mt19937 random(3);
  Indices order(soup.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  Triangle_soup result = soup;
  for(std::size_t v = 0; v < order.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      result.points[order[v]][k]
        = soup.points[v][k] + std::uniform_real_distribution<double>(-length, length)(random);
  for(auto& t : result.triangles)
    for(std::size_t& v : t)
      v = order[v];
  return result;
}

// A square in an inclined plane, and the vertices at its corners.
constexpr std::size_t SIDE = 24;
const Indices corners_of_square = {0, SIDE, SIDE*(SIDE + 1), (SIDE + 1) * (SIDE + 1) - 1};

Surface_component_3 square()
{
  Surface_component_3 result = component(shapes::plane_grid_soup(SIDE, SIDE, 1., 1.));
  result.points = result.points
                  * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())
                      .toRotationMatrix()
                      .transpose();
  return result;
}

// With repeated points, without area, or folded at random.
std::vector<Triangle_soup> degenerate_shapes()
{
  const Triangle_soup ball = shapes::icosphere_soup(3, 1.);
  const Triangle_soup grid = shapes::plane_grid_soup(20, 20, 1., 1.);
  std::vector<Triangle_soup> result(5, grid);
  result[0] = result[1] = ball;
  for(std::size_t f = 0; f < ball.triangles.size(); f += 7)
    result[0].points[ball.triangles[f][0]] = result[0].points[ball.triangles[f][1]];
  for(auto& p : result[1].points)
    p = {{1., 2., 3.}};
  for(auto& p : result[2].points)
    p[1] = 0;
  for(auto& p : result[3].points)
    p[1] *= 1e-9;
  result[4] = irregular(grid, 0.25);
  return result;
}

TEST(Coarse_surface, of_few_vertices_is_a_copy)
{
  const Surface_component_3 surface = component(shapes::torus_soup(12, 8, 2., 0.7));
  Indices all(96);
  std::iota(all.begin(), all.end(), std::size_t(0));
  const Point_matrix values = Point_matrix::Random(96, 3);
  for(const std::size_t number : {std::size_t(96), std::size_t(97), std::size_t(5000)})
  {
    const Coarse_surface_3 coarse = CP::coarse_surface(surface, number);
    expect_valid(coarse, surface);
    EXPECT_EQ(coarse.vertices, all);
    EXPECT_TRUE(coarse.combinations.empty());
    EXPECT_EQ(coarse.surface.points, surface.points);
    EXPECT_EQ(coarse.surface.triangles, surface.triangles);
    EXPECT_EQ(coarse.surface.face_of_triangle, surface.face_of_triangle);
    EXPECT_EQ(coarse.surface.origins, surface.origins);
    EXPECT_EQ(coarse.interpolated(values), values);
  }
}

// The topology of each shape is known: the Euler characteristic is 2 - 2 g - b for genus g and b
// boundary loops. It must not change, whatever number is requested, down to one vertex.
TEST(Coarse_surface, preserves_the_topology)
{
  struct Shape
  {
    std::string name;
    Triangle_soup soup;
    Topology topology;
  };
  const Triangle_soup ball = shapes::icosphere_soup(3, 1.),
                      torus = shapes::torus_soup(48, 24, 2., 0.7);
  const std::vector<Shape> all
    = {{"ball", ball, {2, 0}},
       {"irregular ball", irregular(ball, 0.02), {2, 0}},
       {"torus", torus, {0, 0}},
       {"bent limb", bent(shapes::tube_soup(60, 12, 8., 0.5), 8., 2.5), {2, 0}},
       {"square", shapes::plane_grid_soup(24, 16, 3., 2.), {1, 1}},
       {"strip", shapes::plane_grid_soup(120, 2, 120., 2.), {1, 1}},
       {"band", open_tube(40, 12), {0, 2}},
       {"ball with holes", without_faces(ball, {5, 200, 900, 901, 902, 903}), {-1, 3}},
       {"torus with holes", without_faces(torus, {0, 1, 2, 3, 1000, 1001}), {-2, 2}}};
  for(const Shape& shape : all)
  {
    const Surface_component_3 surface = component(shape.soup);
    ASSERT_TRUE(topology(surface) == shape.topology) << shape.name;
    for(const std::size_t number : {1, 20, 100, 300})
    {
      SCOPED_TRACE(shape.name + ' ' + std::to_string(number));
      const Coarse_surface_3 coarse = CP::coarse_surface(surface, number);
      expect_valid(coarse, surface);
      EXPECT_TRUE(topology(coarse.surface) == shape.topology);
    }
  }
}

// Edges are contracted until the requested number is reached; thin parts, of which there are none
// here, may keep more. The surfaces are triangulated row by row: vertices of a row must not be
// contracted to its end one after the other, which would leave large gaps. The bound of the gaps has
// no proof.
TEST(Coarse_surface, has_about_the_requested_number_of_vertices)
{
  constexpr double largest_gap = 1.6; // in units of the mean distance of neighbors
  const std::vector<Triangle_soup> all
    = {shapes::icosphere_soup(4, 1.), irregular(shapes::icosphere_soup(4, 1.), 0.005),
       shapes::torus_soup(80, 40, 2., 0.7), shapes::plane_grid_soup(40, 40, 1., 1.)};
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    const Surface_component_3 surface = component(all[i]);
    for(const std::size_t number : {100, 300, 1000})
    {
      SCOPED_TRACE(std::to_string(i) + ' ' + std::to_string(number));
      const Coarse_surface_3 coarse = CP::coarse_surface(surface, number);
      EXPECT_LE(coarse.vertices.size(), number + number / 4);
      EXPECT_GE(coarse.vertices.size(), number);
      const double distance = std::sqrt(area(surface) / double(number));
      for(Eigen::Index v = 0; v < surface.points.rows(); ++v)
        EXPECT_LE((coarse.surface.points.rowwise() - surface.points.row(v))
                    .rowwise()
                    .squaredNorm()
                    .minCoeff(),
                  largest_gap * largest_gap * distance * distance);
    }
  }
}

// The height of a tip counts like edges of its length or more: a peak of 0.3 remains where edges of
// about 0.11 are contracted, sqrt(area / (1.6 * 50)).
TEST(Coarse_surface, keeps_tips)
{
  Triangle_soup soup = shapes::plane_grid_soup(20, 20, 1., 1.);
  constexpr std::size_t tip = 10 * 21 + 10;
  soup.points[tip][2] = 0.3;
  const Coarse_surface_3 coarse = CP::coarse_surface(component(soup), 50);
  EXPECT_TRUE(std::binary_search(coarse.vertices.begin(), coarse.vertices.end(), tip));
}

// On a square whose corners are kept, stars of vertices are convex or on its sides, and their faces
// have the same normal: nothing is folded over, so the area remains, and each vertex lies in a face
// of its star. Linear functions are then interpolated exactly, up to rounding.
TEST(Coarse_surface, of_a_square_is_exact)
{
  const Surface_component_3 surface = square();
  const Eigen::RowVector3d direction = normal(surface, 0).normalized();
  const Eigen::Matrix3d linear = Eigen::Matrix3d::Random();
  for(const std::size_t number : {1, 20, 60, 200})
  {
    const Coarse_surface_3 coarse = CP::coarse_surface(surface, number, corners_of_square);
    EXPECT_NEAR(area(coarse.surface), 1., 1e-12);
    for(std::size_t f = 0; f < coarse.surface.triangles.size(); ++f)
      EXPECT_GT(normal(coarse.surface, f).dot(direction), -1e-15); // three vertices of one side
    const Point_matrix values = (surface.points * linear).rowwise() + direction,
                       coarse_values = (coarse.surface.points * linear).rowwise() + direction;
    EXPECT_LT((coarse.interpolated(coarse_values) - values).cwiseAbs().maxCoeff(), 1e-12);
  }
}

// The combinations have nonnegative weights with sum 1: constants remain constant, other values
// stay between the smallest and the largest one. Those at `vertices` are copied.
TEST(Coarse_surface, interpolates_between_its_vertices)
{
  const Surface_component_3 surface = component(shapes::torus_soup(48, 24, 2., 0.7));
  const Coarse_surface_3 coarse = CP::coarse_surface(surface, 200);
  const auto m = Eigen::Index(coarse.vertices.size());
  const Eigen::VectorXd ones
    = coarse.interpolated(Eigen::VectorXd(Eigen::VectorXd::Constant(m, 3.)));
  ASSERT_EQ(ones.size(), surface.points.rows());
  EXPECT_LT((ones.array() - 3.).abs().maxCoeff(), 1e-12);

  const Eigen::MatrixXd values = Eigen::MatrixXd::Random(m, 5);
  const Eigen::MatrixXd all = coarse.interpolated(values);
  for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
    EXPECT_EQ(all.row(Eigen::Index(coarse.vertices[i])), values.row(Eigen::Index(i)));
  for(Eigen::Index j = 0; j < values.cols(); ++j)
  {
    EXPECT_LE(all.col(j).maxCoeff(), values.col(j).maxCoeff() + 1e-12);
    EXPECT_GE(all.col(j).minCoeff(), values.col(j).minCoeff() - 1e-12);
  }

  using Floats = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Floats floats = coarse.interpolated(Floats(values.cast<float>()));
  EXPECT_LT((floats.cast<double>() - all).cwiseAbs().maxCoeff(), 1e-5);

  EXPECT_THROW(coarse.interpolated(Eigen::MatrixXd(values.topRows(m - 1))),
               CGAL::Precondition_exception);
}

// Each vertex is interpolated at the nearest point of a face: on a smooth surface, at a fraction of
// the distance of neighbors.
TEST(Coarse_surface, interpolated_points_are_near)
{
  constexpr double largest_displacement = 0.25; // in units of the mean distance of neighbors
  for(const Triangle_soup& soup :
      {shapes::icosphere_soup(4, 1.), shapes::torus_soup(80, 40, 2., 0.7)})
  {
    const Surface_component_3 surface = component(soup);
    const Coarse_surface_3 coarse = CP::coarse_surface(surface, 700);
    const Point_matrix points = coarse.interpolated(coarse.surface.points);
    EXPECT_LT((points - surface.points).rowwise().norm().maxCoeff(),
              largest_displacement * std::sqrt(area(surface) / 700));
  }
}

TEST(Coarse_surface, kept_vertices_survive)
{
  const Surface_component_3 surface = component(shapes::icosphere_soup(3, 1.));
  Indices kept;
  for(std::size_t v = 0; v < 642; v += 7)
    kept.push_back(v);
  for(const std::size_t number : {1, 20, 300})
  {
    const Coarse_surface_3 coarse = CP::coarse_surface(surface, number, kept);
    expect_valid(coarse, surface);
    EXPECT_TRUE(topology(coarse.surface) == (Topology{2, 0}));
    EXPECT_TRUE(
      std::includes(coarse.vertices.begin(), coarse.vertices.end(), kept.begin(), kept.end()));
  }
  EXPECT_THROW_WITH(CP::coarse_surface(surface, 20, {642}), std::invalid_argument,
                    "vertex 642 is to be kept, but there are 642");
}

// A vertex that survives is not contracted, whether it is kept or not. So a call with the landmarks
// of an earlier one uses the same coarse surface. The order of kept vertices does not matter, nor
// does it matter if they are repeated.
TEST(Coarse_surface, keeping_survivors_changes_nothing)
{
  const Surface_component_3 surface = component(shapes::torus_soup(48, 24, 2., 0.7));
  for(const std::size_t number : {20, 100, 400})
  {
    const Coarse_surface_3 coarse = CP::coarse_surface(surface, number);
    expect_same(CP::coarse_surface(surface, number, coarse.vertices), coarse);
    Indices some = {coarse.vertices.back()};
    for(std::size_t i = 0; i < coarse.vertices.size(); i += 5)
      some.insert(some.end(), 2, coarse.vertices[i]);
    expect_same(CP::coarse_surface(surface, number, some), coarse);
  }
}

// Points are multiplied by a power of two first, such that squares of lengths and of areas neither
// vanish nor overflow: every number is the same in any unit.
TEST(Coarse_surface, does_not_depend_on_the_unit)
{
  const Triangle_soup soup = irregular(shapes::torus_soup(48, 24, 2., 0.7), 0.01);
  const Surface_component_3 surface = component(soup);
  const Coarse_surface_3 coarse = CP::coarse_surface(surface, 150);
  for(const int exponent : {-900, -1, 10, 900})
  {
    Surface_component_3 scaled = surface;
    scaled.points *= std::ldexp(1., exponent);
    const Coarse_surface_3 result = CP::coarse_surface(scaled, 150);
    expect_same(result, coarse);
    EXPECT_EQ(result.surface.points, coarse.surface.points * std::ldexp(1., exponent));
  }
}

// The coarse surface of a sphere is inscribed in it. Its area is smaller by about 0.3 percent;
// paths are shorter by about half as much, and longer where an edge is concave. The bounds are
// larger, for other orders of contraction. Wavefront distances have errors of a few hundredths of a
// percent.
TEST(Coarse_surface, of_a_sphere_has_nearly_the_same_area_and_distances)
{
  constexpr double change_of_area = 0.01, change_of_distances = 0.02;
  const Triangle_soup soup = shapes::icosphere_soup(4, 1.);
  const Surface_component_3 surface = component(soup);
  const Coarse_surface_3 coarse = CP::coarse_surface(surface, 1000);
  EXPECT_NEAR(area(coarse.surface) / area(surface), 1., change_of_area);

  CP::Options options;
  options.geodesics = CP::Options::Geodesics::WAVEFRONT;
  const auto distances = [&](const Surface_component_3& s, const Indices& sources) {
    return CP::geodesic_distances(
      s.points, shapes::to_polygons(Triangle_soup{{}, s.triangles}).polygons, sources, options);
  };
  const Indices sources = {0, coarse.vertices.size() / 3, coarse.vertices.size() - 1};
  Indices fine_sources;
  for(const std::size_t i : sources)
    fine_sources.push_back(coarse.vertices[i]);
  const Eigen::MatrixXd found = distances(coarse.surface, sources),
                        expected = distances(surface, fine_sources);
  ASSERT_EQ(found.rows(), coarse.surface.points.rows());
  for(Eigen::Index j = 0; j < found.cols(); ++j)
    for(Eigen::Index i = 0; i < found.rows(); ++i)
    {
      const double distance = expected(Eigen::Index(coarse.vertices[std::size_t(i)]), j);
      EXPECT_NEAR(found(i, j), distance, change_of_distances * distance);
    }
}

// Topology does not depend on positions: it is preserved if points coincide, if all of them do, if
// they lie on a line, if faces are very thin, or folded over. Nothing is contracted on a surface
// without area.
TEST(Coarse_surface, of_degenerate_faces)
{
  const std::vector<Triangle_soup> all = degenerate_shapes();
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    const Surface_component_3 surface = component(all[i]);
    const Topology expected = topology(surface);
    for(const std::size_t number : {1, 20, 100})
    {
      SCOPED_TRACE(std::to_string(i) + ' ' + std::to_string(number));
      const Coarse_surface_3 coarse = CP::coarse_surface(surface, number);
      expect_valid(coarse, surface);
      EXPECT_TRUE(topology(coarse.surface) == expected);
      EXPECT_TRUE(coarse.interpolated(coarse.surface.points).allFinite());
      if(area(surface) == 0.)
      {
        EXPECT_TRUE(coarse.combinations.empty());
      }
    }
  }
}

// A pose of the surface moves the vertices of the coarse one, and nothing else.
TEST(Coarse_surface, follows_a_pose)
{
  const Triangle_soup soup = shapes::tube_soup(60, 12, 8., 0.5);
  const Surface_component_3 surface = component(soup);
  const Coarse_surface_3 coarse = CP::coarse_surface(surface, 100);
  const Point_matrix pose = shapes::to_matrix(bent(soup, 8., 2.).points);
  const Surface_component_3 posed = coarse.posed(pose);
  EXPECT_EQ(posed.triangles, coarse.surface.triangles);
  EXPECT_EQ(posed.face_of_triangle, coarse.surface.face_of_triangle);
  EXPECT_EQ(posed.origins, coarse.surface.origins);
  ASSERT_EQ(posed.points.rows(), coarse.surface.points.rows());
  for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
    EXPECT_EQ(posed.points.row(Eigen::Index(i)), pose.row(Eigen::Index(coarse.vertices[i])));
  EXPECT_EQ(coarse.posed(surface.points).points, coarse.surface.points);
  EXPECT_THROW(coarse.posed(coarse.surface.points), CGAL::Precondition_exception);
}

} // namespace test_coarse_surface
