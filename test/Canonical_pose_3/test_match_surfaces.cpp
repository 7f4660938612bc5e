// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches of figures in different postures and with different vertices. What is exact: where a vertex of one mesh is on the
// other one is known up to the length of an edge, from their common rest shape.

#include "../../examples/Canonical_pose_3/Articulated_animal.h"
#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/transfer_attributes.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "Triangle_graph.h"
#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace test_match_surfaces {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_examples::Articulated_figure;
using Canonical_pose_test::to_matrix;
using CP::Match_options;
using CP::Matchable_surface_3;
using CP::Point_matrix;
using CP::Surface_match_3;

template <class Triangles>
Point_matrix pose_of(const Point_matrix& points, const Triangles& triangles)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> input, pose;
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    input.emplace_back(points(i, 0), points(i, 1), points(i, 2));
  return CGAL::canonical_pose_3(input, triangles, pose).pose;
}

// In a posture, with its computed pose.
template <class Shape>
struct Posed
{
  Posed(const std::size_t number_of_vertices, const std::size_t posture)
    : shape(number_of_vertices), rest(to_matrix(shape.points())),
      points(to_matrix(shape.points(Shape::named_poses()[posture].angles))),
      pose(pose_of(points, shape.triangles())),
      surface(points, shape.triangles(), pose)
  {}

  const Shape shape;
  const Point_matrix rest, points, pose;
  const Matchable_surface_3 surface;
};

// The mean distance between the places on the rest shape, relative to the root of its area.
template <class Shape>
double root_of_area(const Posed<Shape>& a)
{
  double area = 0;
  for(const auto& t : a.shape.triangles())
  {
    const auto corner = [&](const std::size_t k) -> Eigen::Vector3d {
      return a.rest.row(static_cast<Eigen::Index>(t[k])).transpose();
    };
    area += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return std::sqrt(area);
}

template <class Shape>
double mean_error(const Surface_match_3& match, const Posed<Shape>& a, const Posed<Shape>& b)
{
  return (match.interpolated(b.rest) - a.rest).rowwise().norm().mean() / root_of_area(a);
}

const Posed<Articulated_figure>& running()
{
  static const Posed<Articulated_figure> result(2500, 1);
  return result;
}

const Posed<Articulated_figure>& other()
{
  static const Posed<Articulated_figure> result(3500, 2);
  return result;
}

TEST(Match_surfaces, figures_in_two_postures)
{
  const Surface_match_3 match = CP::match_surfaces(running().surface, other().surface);
  EXPECT_LT(mean_error(match, running(), other()), .02);
  EXPECT_TRUE(match.is_rotation_certain);
  EXPECT_LT(match.round_trips.mean(), .05);
  EXPECT_LT((match.interpolated_at_other(running().rest) - other().rest).rowwise().norm().mean(),
            .02 * root_of_area(other()));
  EXPECT_NEAR(match.scale, 1, .05);
  ASSERT_EQ(match.locations.size(), running().surface.number_of_vertices());
  for(const auto& [face, vertices, weights] : match.locations)
  {
    const auto& corners = other().shape.triangles()[face];
    double sum = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(std::count(corners.begin(), corners.end(), vertices[k]), 1);
      EXPECT_GE(weights[k], 0);
      sum += weights[k];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Match_surfaces, animals_in_two_postures)
{
  const Posed<Articulated_animal> a(2500, 0), b(3000, 2);
  EXPECT_LT(mean_error(CP::match_surfaces(a.surface, b.surface), a, b), .02);
}

// The pose with its second and third axes at equal lengths, but for a stretch by 3 percent at some angle between them, where the
// second axis then is.
Matchable_surface_3 with_second_axis_at(const double angle, const Posed<Articulated_figure>& a)
{
  const Eigen::VectorXd shares = CP::vertex_area_shares(a.pose, a.shape.triangles());
  Point_matrix pose = (CP::canonical_frame(a.pose, shares) * a.pose.transpose()).transpose();
  const Eigen::RowVector3d lengths = (shares.transpose() * pose.cwiseAbs2()).cwiseSqrt();
  pose.col(2) *= lengths[1] / lengths[2];
  const Eigen::Vector3d direction(0, std::cos(angle), std::sin(angle));
  pose += .03 * (pose * direction) * direction.transpose();
  return {a.points, a.shape.triangles(), pose};
}

// Poses coincide but for the frames of their principal axes, which are at any angle.
TEST(Match_surfaces, axes_of_similar_lengths)
{
  const Matchable_surface_3 a = with_second_axis_at(0, running());
  for(const double angle : {.4, .8, 1.2, 2.4})
  {
    const Surface_match_3 match = CP::match_surfaces(a, with_second_axis_at(angle, other()));
    EXPECT_LT(mean_error(match, running(), other()), .02) << "angle " << angle;
    EXPECT_LT(match.mean_distance, .1);
  }
}

// Of a tube with rings, which are in other places for whoever knows only lengths. What is exact: the place along the tube at
// which a vertex was before the tube was stretched; not the turn, since the tube is round.
TEST(Match_surfaces, rings_of_stretched_tubes)
{
  const auto tube = [](const std::size_t sides, const double stretch) {
    Canonical_pose_test::Triangle_soup soup = Canonical_pose_test::tube_soup(160, sides, 8, .5);
    Point_matrix rest = to_matrix(soup.points), points = rest;
    for(Eigen::Index v = 0; v < points.rows(); ++v)
    {
      const double x = rest(v, 0);
      double radius = 1;
      for(const double ring : {.6, 1.4, 2.2, 4.4, 5.6})
        radius += .4 * std::exp(-8 * (x - ring) * (x - ring));
      points.row(v).tail<2>() *= radius;
      points(v, 0) = x + stretch * std::sin(CGAL_PI * x / 4);
    }
    return std::make_pair(rest, Matchable_surface_3(points, soup.triangles, points));
  };
  const auto [rest, a] = tube(24, .15);
  const auto [rest_of_other, b] = tube(27, -.15);
  const Point_matrix found = CP::match_surfaces(a, b).interpolated(rest_of_other);
  const double error = (found.col(0) - rest.col(0)).cwiseAbs().mean();
  EXPECT_LT(error, .05);
}

// The same bytes for any number of threads; and nearly the same match if the poses are moved.
TEST(Match_surfaces, does_not_depend_on_threads_and_frames)
{
  Match_options options;
  options.number_of_registrations = 1;
  const Surface_match_3 match = CP::match_surfaces(running().surface, other().surface, options);
  options.number_of_threads = 1;
  const Surface_match_3 again = CP::match_surfaces(running().surface, other().surface, options);
  EXPECT_TRUE(match.interpolated(other().rest) == again.interpolated(other().rest));
  EXPECT_TRUE(match.round_trips == again.round_trips);

  Eigen::Matrix3d turn;
  turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Point_matrix moved = (3 * other().pose * turn).rowwise() + Eigen::RowVector3d(5, -7, 2);
  const Surface_match_3 of_moved = CP::match_surfaces(
    running().surface, Matchable_surface_3(other().points, other().shape.triangles(), moved), options);
  EXPECT_LT(mean_error(of_moved, running(), other()), .02);
}

// What a match adds to a surface, its body, is made once for all: matches at the same time, also from a parallel loop that would
// run a second one while the first one waits, give the same bytes as those one after the other.
TEST(Match_surfaces, of_a_template_at_the_same_time)
{
  const auto& shape = running();
  const auto surface
    = [&] { return Matchable_surface_3(shape.points, shape.shape.triangles(), shape.pose); };
  const Surface_match_3 expected = CP::match_surfaces(surface(), other().surface);
  const Matchable_surface_3 reference = surface();
  std::array<Surface_match_3, 6> matches;
  CP::internal::for_each_index(matches.size(), [&](const std::size_t i) {
    matches[i] = CP::match_surfaces(reference, other().surface);
  });
  for(const Surface_match_3& match : matches)
    EXPECT_EQ(match.interpolated(other().points), expected.interpolated(other().points));
}

// Lengths whose fourth powers overflow or vanish: a match does not depend on the unit, but its scale is proportional to it.
TEST(Match_surfaces, huge_and_tiny_coordinates)
{
  const auto& shape = running();
  const Surface_match_3 expected = CP::match_surfaces(shape.surface, other().surface);
  for(const double unit : {1e-82, 1e82})
  {
    const Surface_match_3 match = CP::match_surfaces(
      Matchable_surface_3(unit * shape.points, shape.shape.triangles(), unit * shape.pose),
      other().surface);
    EXPECT_NEAR(match.scale / unit, expected.scale, 1e-9 * expected.scale);
    EXPECT_EQ(match.is_rotation_certain, expected.is_rotation_certain);
    EXPECT_NEAR(mean_error(match, shape, other()), mean_error(expected, shape, other()), 1e-3);
  }
}

TEST(Match_surfaces, landmarks_are_met)
{
  Match_options options;
  const std::size_t hand = running().shape.nearest_vertex(running().rest.row(100).transpose()),
                    vertex = other().shape.nearest_vertex(running().rest.row(100).transpose());
  options.landmarks = {{hand, vertex}};
  const Surface_match_3 match = CP::match_surfaces(running().surface, other().surface, options);
  EXPECT_LT(mean_error(match, running(), other()), .02);
  EXPECT_EQ(match.interpolated(other().points).row(static_cast<Eigen::Index>(hand)),
            other().points.row(static_cast<Eigen::Index>(vertex)));
}

// The match with the mirror image is the mirror symmetry: that of the rest shape is x = 0.
template <class Shape>
double error_of_symmetry(const Posed<Shape>& shape)
{
  const Eigen::RowVector3d mirror(-1, 1, 1);
  const Point_matrix points = shape.points * mirror.asDiagonal();
  auto triangles = shape.shape.triangles();
  for(auto& t : triangles)
    std::swap(t[0], t[1]);
  const Surface_match_3 match
    = CP::match_surfaces(shape.surface, Matchable_surface_3(points, triangles, pose_of(points, triangles)));
  return (match.interpolated(shape.rest) - shape.rest * mirror.asDiagonal()).rowwise().norm().mean()
         / root_of_area(shape);
}

TEST(Match_surfaces, mirror_symmetry)
{
  EXPECT_LT(error_of_symmetry(running()), .03);
  EXPECT_LT(error_of_symmetry(Posed<Articulated_animal>(2500, 2)), .03);
}

// A mesh with a hundred times the vertices, and holes in the other one: the same curved surface, which has no symmetry, is its own
// pose. Its parameters are points of the unit sphere.
TEST(Match_surfaces, very_different_meshes)
{
  using namespace Canonical_pose_test;
  const Triangle_soup coarse = icosphere_soup(3, 1.), fine = icosphere_soup(6, 1.);
  const Point_matrix of_coarse = to_matrix(coarse.points), of_fine = to_matrix(fine.points);
  const auto surface = [](Point_matrix points) {
    for(auto p : points.rowwise())
      p = Eigen::RowVector3d(3 * p.x() + p.y() * p.y(), 2 * p.y() + .8 * p.x() * p.z(), p.z() + .5 * p.x() * p.x());
    return points;
  };
  CP::Face_list with_holes;
  for(std::size_t f = 0; f < coarse.triangles.size(); ++f)
    if(f % 100 != 0)
      with_holes.push_back(coarse.triangles[f]);
  const Surface_match_3 match
    = CP::match_surfaces(Matchable_surface_3(surface(of_coarse), with_holes, surface(of_coarse)),
                         Matchable_surface_3(surface(of_fine), fine.triangles, surface(of_fine)));
  constexpr double edge = .15; // of the coarse mesh, about
  EXPECT_LT((match.interpolated(of_fine) - of_coarse).rowwise().norm().mean(), edge);
  EXPECT_LT((match.interpolated_at_other(of_coarse) - of_fine).rowwise().norm().mean(), edge);
}

// Each face with vertices of its own, as in many files: copies of a vertex are at the same place, and the places of others
// are corners of the faces that they name.
TEST(Match_surfaces, faces_without_common_vertices)
{
  const auto& triangles = running().shape.triangles();
  std::vector<std::size_t> origins;
  CP::Face_list soup;
  for(const auto& t : triangles)
  {
    soup.push_back({origins.size(), origins.size() + 1, origins.size() + 2});
    origins.insert(origins.end(), t.begin(), t.end());
  }
  const auto copies = [&](const Point_matrix& points) { return Point_matrix(points(origins, Eigen::all)); };
  const Matchable_surface_3 surface(copies(running().points), soup, copies(running().pose));
  Match_options options;
  options.number_of_registrations = 1;
  const Surface_match_3 match = CP::match_surfaces(surface, other().surface, options);
  const Point_matrix places = match.interpolated(other().rest);
  EXPECT_LT((places - copies(running().rest)).rowwise().norm().mean(), .02 * root_of_area(running()));
  std::vector<Eigen::Index> first(running().shape.points().size(), -1);
  for(std::size_t v = 0; v < origins.size(); ++v)
    if(Eigen::Index& copy = first[origins[v]]; copy < 0)
      copy = static_cast<Eigen::Index>(v);
    else
      EXPECT_EQ(places.row(static_cast<Eigen::Index>(v)), places.row(copy));
  for(const auto& [face, vertices, weights] : match.locations_of_other)
    for(const std::size_t v : vertices)
      EXPECT_EQ(std::count(soup[face].begin(), soup[face].end(), v), 1);

  const Surface_match_3 of_itself = CP::match_surfaces(running().surface, surface, options);
  const std::vector<std::size_t> matched
    = CP::matched_faces(of_itself, triangles, copies(running().points), soup);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    EXPECT_EQ(matched[f], f);
}

// A surface that is matched with itself has its own faces.
TEST(Match_surfaces, faces_of_itself)
{
  const CP::Face_list faces = running().shape.triangles();
  Surface_match_3 match;
  match.locations.resize(running().surface.number_of_vertices());
  for(std::size_t f = 0; f < faces.size(); ++f) // whichever face a vertex names
    for(std::size_t k = 0; k < 3; ++k)
      match.locations[faces[f][k]]
        = {f, {faces[f][0], faces[f][1], faces[f][2]}, {k == 0 ? 1. : 0., k == 1 ? 1. : 0., k == 2 ? 1. : 0.}};
  const std::vector<std::size_t> matched = CP::matched_faces(match, faces, running().points, faces);
  for(std::size_t f = 0; f < faces.size(); ++f)
    EXPECT_EQ(matched[f], f);
}

// Texture coordinates are x and y, and x is larger by 10 beyond a seam. So those of each face that is transferred are its x and y,
// up to one number, 0 or 10.
TEST(Match_surfaces, texture_across_a_seam)
{
  const auto grid = [](const std::size_t n, Point_matrix& points) {
    CP::Face_list faces;
    points.resize(static_cast<Eigen::Index>((n + 1) * (n + 1)), 3);
    for(std::size_t i = 0; i <= n; ++i)
      for(std::size_t j = 0; j <= n; ++j)
      {
        points.row(static_cast<Eigen::Index>(i * (n + 1) + j))
          << static_cast<double>(j) / static_cast<double>(n), static_cast<double>(i) / static_cast<double>(n), 0;
        const std::size_t v = i * (n + 1) + j;
        if(i < n && j < n)
          faces.push_back({v, v + 1, v + n + 2, v + n + 1});
      }
    return faces;
  };
  constexpr std::size_t n = 8, m = 6;
  Point_matrix points, of_other;
  const CP::Face_list faces = grid(n, points), faces_of_other = grid(m, of_other);
  std::vector<std::array<float, 2>> coordinates;
  for(std::size_t f = 0; f < faces_of_other.size(); ++f)
    for(const std::size_t v : faces_of_other[f])
      coordinates.push_back({static_cast<float>(of_other(static_cast<Eigen::Index>(v), 0)) + (f % m < m / 2 ? 0 : 10),
                             static_cast<float>(of_other(static_cast<Eigen::Index>(v), 1))});
  Surface_match_3 match;
  for(Eigen::Index v = 0; v < points.rows(); ++v)
  {
    const auto cell = [&](const Eigen::Index k) { return (std::min)(m - 1, static_cast<std::size_t>(m * points(v, k))); };
    const std::size_t face = cell(1) * m + cell(0);
    const double x = m * points(v, 0) - static_cast<double>(cell(0)), y = m * points(v, 1) - static_cast<double>(cell(1));
    const auto corners = faces_of_other[face];
    if(x > y)
      match.locations.push_back({face, {corners[0], corners[1], corners[2]}, {1 - x, x - y, y}});
    else
      match.locations.push_back({face, {corners[0], corners[2], corners[3]}, {1 - y, x, y - x}});
  }
  const std::vector<std::array<float, 2>> result
    = CP::transferred_texture_coordinates(match, faces, of_other, faces_of_other, coordinates);
  const std::vector<std::size_t> matched = CP::matched_faces(match, faces, of_other, faces_of_other);
  std::size_t corner = 0;
  for(std::size_t f = 0; f < faces.size(); ++f)
    for(const std::size_t v : faces[f])
    {
      EXPECT_NEAR(result[corner][0], points(static_cast<Eigen::Index>(v), 0) + (matched[f] % m < m / 2 ? 0 : 10), 1e-5);
      EXPECT_NEAR(result[corner++][1], points(static_cast<Eigen::Index>(v), 1), 1e-5);
    }
  EXPECT_EQ(corner, result.size());
}

// Meshes are matched as their points and faces are.
template <class Mesh>
class Match_of_meshes : public testing::Test
{};

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Meshes = testing::Types<CGAL::Surface_mesh<Point>, CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>;
TYPED_TEST_SUITE(Match_of_meshes, Meshes);

TYPED_TEST(Match_of_meshes, is_that_of_arrays)
{
  const Canonical_pose_test::Triangle_soup ball = Canonical_pose_test::icosphere_soup(2, 1.);
  Point_matrix points = to_matrix(ball.points);
  points.col(0) *= 3;
  points.col(1) *= 2;
  const TypeParam mesh = CP::make_triangle_mesh<TypeParam>(points, ball.triangles);
  const auto map = get(CGAL::vertex_point, mesh);
  Match_options options;
  options.number_of_registrations = 1;
  const Matchable_surface_3 of_arrays(points, ball.triangles, points);
  const Surface_match_3 expected = CP::match_surfaces(of_arrays, of_arrays, options);
  for(const Matchable_surface_3& surface :
      {Matchable_surface_3(mesh, map), Matchable_surface_3(mesh, map, CGAL::parameters::vertex_point_map(map))})
    EXPECT_LT((CP::match_surfaces(surface, surface, options).interpolated(points) - expected.interpolated(points)).norm(),
              1e-9); // faces may start at other corners
}

// An egg with a bump, so that it has no symmetry.
Canonical_pose_test::Triangle_soup egg(const int level)
{
  Canonical_pose_test::Triangle_soup soup = Canonical_pose_test::icosphere_soup(level, 1.);
  for(auto& p : soup.points)
    p = {3 * p[0] + p[1] * p[1], 2 * p[1] + .8 * p[0] * p[2], p[2] + .5 * p[0] * p[0]};
  return soup;
}

template <class Mesh>
using Vertex_of = typename boost::graph_traits<Mesh>::vertex_descriptor;
template <class Mesh>
using Location_on = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

// Values of vertices in a container.
template <class Mesh, class Value>
struct Vertex_values
{
  auto map() { return boost::make_assoc_property_map(values); }

  std::unordered_map<Vertex_of<Mesh>, Value> values;
};

void expect_equal(const Surface_match_3& match, const Surface_match_3& expected)
{
  ASSERT_EQ(match.locations.size(), expected.locations.size());
  for(std::size_t v = 0; v < match.locations.size(); ++v)
  {
    EXPECT_EQ(match.locations[v].face, expected.locations[v].face);
    EXPECT_EQ(match.locations[v].vertices, expected.locations[v].vertices);
    EXPECT_EQ(match.locations[v].weights, expected.locations[v].weights);
  }
  EXPECT_TRUE(match.round_trips == expected.round_trips);
}

// Locations of vertices are points of a mesh, those of the match.
template <class Mesh, class Other, class Map>
void expect_points(const Mesh& mesh, const Other& other, const Map& locations,
                   const Point_matrix& expected)
{
  Eigen::Index row = 0;
  for(const Vertex_of<Mesh> v : vertices(mesh))
  {
    const Location_on<Other> location = get(locations, v);
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_in_face(location, other));
    const auto point = CGAL::Polygon_mesh_processing::construct_point(location, other);
    EXPECT_LT((Eigen::RowVector3d(point.x(), point.y(), point.z()) - expected.row(row++)).norm(),
              1e-12);
  }
}

// Of surface meshes, with the pose of the first one.
struct Match_of_eggs
{
  using Mesh = CGAL::Surface_mesh<Point>;

  Match_of_eggs() : pose(Canonical_pose_test::to_mesh<Mesh>(egg(2)))
  {
    const auto mesh = pose, other = Canonical_pose_test::to_mesh<Mesh>(egg(1));
    Vertex_values<Mesh, std::pair<CGAL::SM_Face_index, std::array<float, 3>>> floats;
    match = CP::match_surfaces(mesh, other, floats.map());
    EXPECT_EQ(floats.values.size(), num_vertices(mesh));
    CGAL::canonical_pose_3(mesh, pose.points());
  }

  static const Match_of_eggs& instance()
  {
    static const Match_of_eggs result;
    return result;
  }

  Mesh pose;
  Surface_match_3 match;
};

TYPED_TEST(Match_of_meshes, is_written)
{
  const auto mesh = Canonical_pose_test::to_mesh<TypeParam>(egg(2)),
             other = Canonical_pose_test::to_mesh<TypeParam>(egg(1));
  Vertex_values<TypeParam, Location_on<TypeParam>> locations, back;
  const Surface_match_3 match = CP::match_surfaces(mesh, other, locations.map());
  EXPECT_LT(
    (match.interpolated(CP::point_matrix(other)) - CP::point_matrix(mesh)).rowwise().norm().mean(),
    .5);
  expect_points(mesh, other, locations.map(), match.interpolated(CP::point_matrix(other)));
  CP::put_locations(match.locations_of_other, other, mesh, back.map());
  expect_points(other, mesh, back.map(), match.interpolated_at_other(CP::point_matrix(mesh)));

  // The same bytes for any mesh, with points of the caller, and with given poses.
  expect_equal(match, Match_of_eggs::instance().match);

  TypeParam moved = mesh, moved_other = other;
  Vertex_values<TypeParam, Point> points, other_points;
  for(auto [of_mesh, values] :
      {std::make_pair(&moved, &points), std::make_pair(&moved_other, &other_points)})
    for(const auto v : vertices(*of_mesh))
    {
      const auto map = get(CGAL::vertex_point, *of_mesh);
      values->values[v] = get(map, v);
      put(map, v, Point(0, 0, 0));
    }
  const auto np = CGAL::parameters::vertex_point_map(points.map()),
             np_of_other = CGAL::parameters::vertex_point_map(other_points.map());
  Vertex_values<TypeParam, Location_on<TypeParam>> again;
  expect_equal(match, CP::match_surfaces(moved, moved_other, again.map(), np, np_of_other));
  EXPECT_EQ(again.values.size(), num_vertices(mesh));

  Vertex_values<TypeParam, Point> pose;
  CP::put_points(CP::point_matrix(Match_of_eggs::instance().pose), mesh, pose.map(),
                 CGAL::Simple_cartesian<double>());
  expect_equal(match, CP::match_surfaces(Matchable_surface_3(mesh, pose.map()),
                                         CP::matchable_surface(moved_other, np_of_other)));
}

// An ellipsoid looks the same after half turns, also where one of them matches its vertices exactly; with a bump, it does not.
TEST(Match_surfaces, rotations_of_symmetric_shapes_are_in_doubt)
{
  const auto is_certain = [](const Canonical_pose_test::Triangle_soup& soup) {
    const Point_matrix points = to_matrix(soup.points),
                       turned = points * Eigen::Vector3d(-1, -1, 1).asDiagonal();
    const Matchable_surface_3 surface(points, soup.triangles, points);
    const bool result = CP::match_surfaces(surface, surface).is_rotation_certain;
    EXPECT_EQ(CP::match_surfaces(surface, Matchable_surface_3(turned, soup.triangles, turned))
                .is_rotation_certain,
              result);
    return result;
  };
  Canonical_pose_test::Triangle_soup ellipsoid = Canonical_pose_test::icosphere_soup(3, 1.);
  for(auto& p : ellipsoid.points)
    p = {3 * p[0], 2 * p[1], p[2]};
  EXPECT_FALSE(is_certain(ellipsoid));
  EXPECT_TRUE(is_certain(egg(3)));
}

TEST(Match_surfaces, face_graphs_of_others)
{
  using archetype::Hashed_graph;
  const auto mesh = Canonical_pose_test::to_mesh<CGAL::Surface_mesh<Point>>(egg(2));
  const Hashed_graph graph(egg(2)), other(egg(1));
  Vertex_values<Hashed_graph, std::pair<Hashed_graph::Face, std::array<double, 3>>> locations;
  const Surface_match_3 match = CP::match_surfaces(graph, other, locations.map());
  EXPECT_EQ(locations.values.size(), num_vertices(mesh));
  Vertex_values<CGAL::Surface_mesh<Point>, std::pair<Hashed_graph::Face, std::array<double, 3>>>
    of_mesh;
  expect_equal(match, CP::match_surfaces(mesh, other, of_mesh.map()));
  for(const auto v : vertices(mesh))
    EXPECT_EQ(of_mesh.values[v].second, locations.values[{static_cast<std::size_t>(v)}].second);
}

// Quads may be matched, but have no locations of CGAL.
TEST(Match_surfaces, meshes_that_are_refused)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  const auto mesh = Canonical_pose_test::to_mesh<Mesh>(egg(1));
  Vertex_values<Mesh, Location_on<Mesh>> locations;
  const auto match = [&](const Mesh& a, const Mesh& b) {
    const Surface_match_3 result = CP::match_surfaces(a, b, locations.map());
    EXPECT_EQ(locations.values.size(), num_vertices(a));
    locations.values.clear();
    return result;
  };
  Mesh with_quad = mesh, open = mesh, with_nan = mesh, two = mesh, empty;
  CGAL::Euler::join_face(halfedge(*edges(with_quad).begin(), with_quad), with_quad);
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  with_nan.point(Mesh::Vertex_index(7)) = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  for(const auto v : vertices(mesh))
    two.add_vertex(mesh.point(v) + CGAL::Simple_cartesian<double>::Vector_3(20, 0, 0));
  const auto n = static_cast<Mesh::size_type>(num_vertices(mesh));
  for(const auto f : faces(mesh))
  {
    std::vector<Mesh::Vertex_index> corners;
    for(const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      corners.emplace_back(v + n);
    two.add_face(corners);
  }
  EXPECT_EQ(match(with_quad, open).locations.size(), n);
  EXPECT_EQ(match(open, mesh).locations.size(), n);

  const std::string no_triangle = "is not a triangle",
                    not_finite = "vertex 7 has a coordinate that is not finite",
                    several = "the surface has 2 connected components",
                    other_mesh = "the other mesh: ";
  EXPECT_THROW_WITH(match(mesh, with_quad), std::invalid_argument, other_mesh + "face ");
  EXPECT_THROW_WITH(match(mesh, with_quad), std::invalid_argument, no_triangle);
  EXPECT_THROW_WITH(match(with_nan, mesh), std::invalid_argument, not_finite);
  EXPECT_THROW_WITH(match(mesh, with_nan), std::invalid_argument, other_mesh + not_finite);
  EXPECT_THROW_WITH(match(two, mesh), std::invalid_argument, several);
  EXPECT_THROW_WITH(match(mesh, two), std::invalid_argument, other_mesh + several);
  EXPECT_THROW_WITH(match(empty, mesh), std::invalid_argument, "no face");
  EXPECT_THROW_WITH(match(mesh, empty), std::invalid_argument, other_mesh);
  Match_options options;
  options.landmarks = {{0, n}};
  EXPECT_THROW_WITH(CP::match_surfaces(with_nan, mesh, locations.map(), options),
                    std::invalid_argument, "the landmark 0, 42 is out of range");
  EXPECT_TRUE(locations.values.empty());

  CP::Options each;
  each.components = CP::Options::Components::EACH;
  const Surface_match_3 of_two
    = CP::match_surfaces(CP::matchable_surface(two, each), CP::matchable_surface(mesh));
  CP::put_locations(of_two.locations, two, mesh, locations.map());
  EXPECT_EQ(locations.values.size(), 2 * n);
}

// The figure with a vertex without faces, a ball and a sliver without area, all far away.
Matchable_surface_3 with_dirt(const Posed<Articulated_figure>& figure, const double distance)
{
  const Canonical_pose_test::Triangle_soup ball = Canonical_pose_test::icosphere_soup(2, .03);
  const Point_matrix of_ball
    = to_matrix(ball.points).rowwise() + Eigen::RowVector3d(distance, 0, 0);
  Point_matrix others(4, 3);
  others << 0, distance, 0, 0, 0, distance, 1, 0, distance, 2, 0, distance;
  const auto with_others = [&](const Point_matrix& points) {
    Point_matrix result(points.rows() + of_ball.rows() + others.rows(), 3);
    result << points, of_ball, others;
    return result;
  };
  CP::Face_list faces = figure.shape.triangles();
  const auto first = static_cast<std::size_t>(figure.points.rows()),
             last = first + ball.points.size();
  for(const auto& t : ball.triangles)
    faces.push_back({t[0] + first, t[1] + first, t[2] + first});
  faces.push_back({last + 1, last + 2, last + 3});
  return {with_others(figure.points), faces, with_others(figure.pose)};
}

TEST(Match_surfaces, dirt_has_no_influence)
{
  const Surface_match_3 expected = CP::match_surfaces(running().surface, other().surface);
  EXPECT_EQ(expected.mean_round_trip, expected.round_trips.mean());
  const Matchable_surface_3 with_dirt_of_a = with_dirt(running(), 30),
                            with_dirt_of_b = with_dirt(other(), -50);
  for(const Matchable_surface_3& a : {running().surface, with_dirt_of_a})
    for(const Matchable_surface_3& b : {other().surface, with_dirt_of_b})
    {
      Match_options options; // landmarks of dirt count for themselves alone
      if(a.number_of_vertices() > static_cast<std::size_t>(running().rest.rows()))
        options.landmarks.emplace_back(a.number_of_vertices() - 1, 0);
      const Surface_match_3 match = CP::match_surfaces(a, b, options);
      EXPECT_EQ(match.locations.size(), a.number_of_vertices());
      EXPECT_NEAR(match.mean_distance, expected.mean_distance, .002);
      EXPECT_NEAR(match.mean_round_trip, expected.mean_round_trip, .001);
      EXPECT_TRUE(match.is_rotation_certain);
      double error = 0;
      for(Eigen::Index v = 0; v < running().rest.rows(); ++v)
      {
        const auto& [face, vertices, weights] = match.locations[static_cast<std::size_t>(v)];
        Eigen::RowVector3d point(0, 0, 0);
        for(std::size_t k = 0; k < 3; ++k)
        {
          ASSERT_LT(vertices[k], static_cast<std::size_t>(other().rest.rows()))
            << "vertex " << v << " is on dirt";
          point += weights[k] * other().rest.row(static_cast<Eigen::Index>(vertices[k]));
        }
        error += (point - running().rest.row(v)).norm();
      }
      EXPECT_LT(error / static_cast<double>(running().rest.rows()), .02 * root_of_area(running()));
    }
}

// Exact: where the vertices of the figure are does not depend on another figure beside either one, which is not compared: small or
// nearly as large. Parts that are near, as clothes are, are compared.
TEST(Match_surfaces, shapes_beside_have_no_influence)
{
  const auto with_other
    = [](const Posed<Articulated_figure>& figure, const double scale, const double gap) {
        const double width = figure.points.col(0).maxCoeff() - figure.points.col(0).minCoeff();
        const auto both = [&](const Point_matrix& points) {
          Point_matrix result(2 * points.rows(), 3);
          result << points, (scale * points).rowwise() + Eigen::RowVector3d(width + gap, 0, 0);
          return result;
        };
        CP::Face_list faces = figure.shape.triangles();
        const auto n = static_cast<std::size_t>(figure.points.rows());
        for(const auto& t : figure.shape.triangles())
          faces.push_back({t[0] + n, t[1] + n, t[2] + n});
        return Matchable_surface_3(both(figure.points), faces, both(figure.pose));
      };
  const Surface_match_3 expected = CP::match_surfaces(running().surface, other().surface);
  for(const double scale : {.4, .9})
  {
    const Matchable_surface_3 a = with_other(running(), scale, .5),
                              b = with_other(other(), scale, .5);
    const auto expect_same = [&](const Surface_match_3& match) {
      EXPECT_EQ(match.mean_round_trip, expected.mean_round_trip);
      EXPECT_EQ(match.mean_distance, expected.mean_distance);
      for(std::size_t v = 0; v < expected.locations.size(); ++v)
      {
        ASSERT_EQ(match.locations[v].vertices, expected.locations[v].vertices);
        ASSERT_EQ(match.locations[v].weights, expected.locations[v].weights);
      }
    };
    expect_same(CP::match_surfaces(a, other().surface));
    expect_same(CP::match_surfaces(running().surface, b));
    const Surface_match_3 match = CP::match_surfaces(a, b);
    expect_same(match);
    EXPECT_NEAR(match.compared_share, 1 / (1 + scale * scale), 1e-12);
    EXPECT_NEAR(match.compared_share_of_other, 1 / (1 + scale * scale), 1e-12);
    Match_options options;
    options.landmarks = {{0, b.number_of_vertices() - 1}}; // of what has no influence
    EXPECT_THROW_WITH(CP::match_surfaces(running().surface, b, options), std::invalid_argument,
                      "is on a component far from the largest one");
  }
  EXPECT_EQ(expected.compared_share, 1);
}

// A surface of three times the size has itself as its match, which changes no length. A ball has no
// limbs, so lengths of a figure do change.
TEST(Match_surfaces, edge_strain)
{
  const Matchable_surface_3 larger(3 * running().points, running().shape.triangles(),
                                   running().pose);
  EXPECT_LT(CP::match_surfaces(running().surface, larger).edge_strain, 1e-6);
  EXPECT_LT(CP::match_surfaces(running().surface, other().surface).edge_strain, .2);
  using namespace Canonical_pose_test;
  const Triangle_soup ball = icosphere_soup(3, 1.);
  const Matchable_surface_3 of_ball(to_matrix(ball.points), ball.triangles, to_matrix(ball.points));
  EXPECT_GT(CP::match_surfaces(running().surface, of_ball).edge_strain, .3);
}

// Shapes of different kinds have no match that is right, but they have one.
TEST(Match_surfaces, any_shapes)
{
  using namespace Canonical_pose_test;
  const Triangle_soup ball = icosphere_soup(3, 1.);
  const Point_matrix of_ball = to_matrix(ball.points);
  Point_matrix two(2 * of_ball.rows(), 3);
  two << of_ball, (2 * of_ball).rowwise() + Eigen::RowVector3d(5, 0, 0);
  CP::Face_list faces_of_two = ball.triangles;
  for(const auto& t : ball.triangles)
    faces_of_two.push_back({t[0] + ball.points.size(), t[1] + ball.points.size(), t[2] + ball.points.size()});
  Point_matrix cube(9, 3); // the last vertex belongs to no face
  cube << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 9, 9, 9;
  const CP::Face_list sides
    = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {3, 0, 4, 7}, {1, 2, 6, 5}};
  std::vector<Matchable_surface_3> surfaces;
  surfaces.emplace_back(of_ball, ball.triangles, of_ball);
  surfaces.emplace_back(two, faces_of_two, two);
  surfaces.emplace_back(cube, sides, cube);
  for(const Matchable_surface_3& a : surfaces)
    for(const Matchable_surface_3& b : surfaces)
    {
      const Surface_match_3 match = CP::match_surfaces(a, b);
      ASSERT_EQ(match.locations.size(), a.number_of_vertices());
      for(const auto& [face, vertices, weights] : match.locations)
        for(std::size_t k = 0; k < 3; ++k)
        {
          EXPECT_LT(vertices[k], b.number_of_vertices());
          EXPECT_TRUE(weights[k] >= 0 && weights[k] <= 1);
        }
    }
}

TEST(Match_surfaces, misuse)
{
  using namespace Canonical_pose_test;
  const Triangle_soup ball = icosphere_soup(1, 1.);
  const Point_matrix points = to_matrix(ball.points);
  EXPECT_THROW_WITH(Matchable_surface_3(points, ball.triangles, points.topRows(3)), std::invalid_argument,
                    "there are 42 vertices, but the pose has 3");
  EXPECT_THROW_WITH(
    Matchable_surface_3(points, ball.triangles,
                        Point_matrix::Constant(42, 3, std::numeric_limits<double>::quiet_NaN())),
    std::invalid_argument, "not finite");
  const Matchable_surface_3 surface(points, ball.triangles, points);
  Match_options options;
  options.landmarks = {{0, 42}};
  EXPECT_THROW_WITH(CP::match_surfaces(surface, surface, options), std::invalid_argument, "the landmark 0, 42 is out of range");
  options.landmarks = {{3, 1}, {0, 5}, {3, 2}};
  EXPECT_THROW_WITH(CP::match_surfaces(surface, surface, options), std::invalid_argument,
                    "the landmarks match vertex 3 with vertices 1 and 2");
  options.landmarks = {{1, 7}, {2, 7}};
  EXPECT_THROW_WITH(CP::match_surfaces(surface, surface, options), std::invalid_argument,
                    "the landmarks match vertex 7 of the other surface with vertices 1 and 2");
  options = Match_options();
  options.number_of_functions = 3;
  EXPECT_THROW_WITH(CP::match_surfaces(surface, surface, options), std::invalid_argument, "must be at least 4");
  options = Match_options();
  for(const double weight : {0., 1e7, std::numeric_limits<double>::quiet_NaN()})
  {
    options.pose_weight = weight;
    EXPECT_THROW_WITH(CP::match_surfaces(surface, surface, options), std::invalid_argument,
                      "must be positive");
  }
  options = Match_options();
  options.number_of_registrations = -1;
  EXPECT_THROW_WITH(CP::match_surfaces(surface, surface, options), std::invalid_argument, "must not be negative");
}

} // namespace test_match_surfaces
