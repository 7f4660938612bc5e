// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/extract_boundary.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_parts_of_complexes {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using shapes::Tetrahedral_soup;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

CP::Indexed_tetrahedra_3<Point_3> complex_of(const Tetrahedral_soup& soup)
{
  CP::Indexed_tetrahedra_3<Point_3> complex;
  for(const auto& p : soup.points)
    complex.points.emplace_back(p[0], p[1], p[2]);
  complex.cells = soup.cells;
  return complex;
}

CP::Result pose_of(const Tetrahedral_soup& soup, const CP::Options& options = CP::Options())
{
  const auto complex = complex_of(soup);
  std::vector<Point_3> pose(soup.points.size());
  const CP::Result result = CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), options);
  EXPECT_EQ(shapes::to_matrix(pose), result.pose);
  return result;
}

// The vertex of the complex of each row of targets and distances.
std::vector<std::size_t> vertices_of_rows(const Tetrahedral_soup& soup)
{
  CGAL::Surface_mesh<Point_3> boundary;
  auto origins
    = boundary.add_property_map<CGAL::Surface_mesh<Point_3>::Vertex_index, std::size_t>("v:origin")
        .first;
  CP::extract_boundary(complex_of(soup), boundary, origins);
  std::vector<std::size_t> result;
  for(const auto v : boundary.vertices())
    result.push_back(origins[v]);
  return result;
}

CP::Options with(const CP::Options::Components components)
{
  CP::Options options;
  options.components = components;
  return options;
}

// A bent bar, 8 long and 1.2 thick, with or without the cells around its middle fiber.
Tetrahedral_soup bar(const bool has_cavity)
{
  const std::array<double, 3> lengths = {{8., 1.2, 1.2}};
  const Tetrahedral_soup straight = shapes::tetrahedral_box(40, 6, 6, lengths);
  Tetrahedral_soup soup = shapes::tetrahedral_bent_bar(40, 6, 6, 2., lengths);
  soup.cells.clear();
  for(const auto& cell : straight.cells)
  {
    std::array<double, 3> middle = {{0., 0., 0.}};
    for(const std::size_t v : cell)
      for(std::size_t k = 0; k < 3; ++k)
        middle[k] += straight.points[v][k] / 4;
    const bool is_inside = std::abs(middle[0] - 4) < 2 && std::abs(middle[1] - 0.6) < 0.4
                           && std::abs(middle[2] - 0.6) < 0.4;
    if(!has_cavity || !is_inside)
      soup.cells.push_back(cell);
  }
  return soup;
}

// Vertices of the first complex are first.
Tetrahedral_soup merged(Tetrahedral_soup a, const Tetrahedral_soup& b, const double shift)
{
  const std::size_t n = a.points.size();
  for(const auto& p : b.points)
    a.points.push_back({{p[0] + shift, p[1], p[2]}});
  for(const auto& c : b.cells)
    a.cells.push_back({{c[0] + n, c[1] + n, c[2] + n, c[3] + n}});
  return a;
}

Tetrahedral_soup small_bar() { return shapes::tetrahedral_bent_bar(48, 6, 6, 2., {{4., .5, .5}}); }
const Eigen::Index small_size = Eigen::Index(small_bar().points.size());

// A straight bar of 10 x 1 x 1 cubes, and a bar of half the size, or a small cell, at its last vertex.
Tetrahedral_soup long_bar() { return shapes::tetrahedral_box(10, 1, 1, {{10., 1., 1.}}); }

Tetrahedral_soup with_cell_at_a_vertex(Tetrahedral_soup soup)
{
  const std::size_t n = soup.points.size();
  const auto p = soup.points.back();
  for(const std::array<double, 3>& side :
      {std::array<double, 3>{{.1, 0, 0}}, {{0, .1, 0}}, {{0, 0, .1}}})
    soup.points.push_back({{p[0] + side[0], p[1] + side[1], p[2] + side[2]}});
  soup.cells.push_back({{n - 1, n, n + 1, n + 2}});
  return soup;
}

Tetrahedral_soup with_bar_at_a_vertex(const Tetrahedral_soup& soup)
{
  Tetrahedral_soup other = shapes::tetrahedral_box(10, 1, 1, {{5., .5, .5}});
  const std::size_t n = soup.points.size();
  for(auto& p : other.points) // its vertex 0 is at 0
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += soup.points.back()[k];
  Tetrahedral_soup both = merged(soup, other, 0.);
  for(auto& c : both.cells)
    std::replace(c.begin(), c.end(), n, n - 1);
  return both;
}

Tetrahedral_soup two_bars() { return merged(small_bar(), bar(true), 20.); }

template <class Container, class Index, class = void>
struct Is_indexed_by : std::false_type
{};

template <class Container, class Index>
struct Is_indexed_by<
  Container, Index, std::void_t<decltype(std::declval<Container&>()[std::declval<const Index&>()])>>
  : std::true_type
{};

// What is per vertex cannot be indexed by rows, nor the other way round, nor by plain numbers.
TEST(Parts_of_complexes, indices_have_types)
{
  using namespace CP::internal;
  using Of_vertices = decltype(Vertex_map::component_of);
  using Of_rows = decltype(Vertex_map::vertex_of_row);
  static_assert(Is_indexed_by<Of_vertices, Vertex_index>::value, "");
  static_assert(!Is_indexed_by<Of_vertices, Row_index>::value, "");
  static_assert(!Is_indexed_by<Of_vertices, Component_index>::value, "");
  static_assert(!Is_indexed_by<Of_vertices, std::size_t>::value, "");
  static_assert(Is_indexed_by<Of_rows, Row_index>::value, "");
  static_assert(!Is_indexed_by<Of_rows, Vertex_index>::value, "");
  static_assert(!Is_indexed_by<decltype(rows_by<Row_index>(std::declval<Point_matrix&>())),
                               Vertex_index>::value,
                "");
  static_assert(!std::is_convertible<Row_index, Vertex_index>::value, "");
}

// The boundary is split at the common vertex, so it has more rows than the complex has vertices. The
// distances are those of the bar alone, bit for bit, since the cell is not on its surface; it has no
// target and moves with the bar.
TEST(Parts_of_complexes, more_rows_than_vertices)
{
  const Tetrahedral_soup soup = with_cell_at_a_vertex(long_bar());
  const std::vector<std::size_t> vertices = vertices_of_rows(soup);
  const std::size_t n = long_bar().points.size();
  ASSERT_EQ(vertices.size(), soup.points.size() + 1);
  CP::Options options;
  options.return_landmark_fields = true;
  const CP::Result alone = pose_of(long_bar(), options), both = pose_of(soup, options);
  ASSERT_EQ(both.target->rows(), Eigen::Index(vertices.size()));
  ASSERT_EQ(both.landmark_fields->distances.rows(), Eigen::Index(vertices.size()));
  std::vector<std::size_t> row_of(n);
  const std::vector<std::size_t> vertices_alone = vertices_of_rows(long_bar());
  for(std::size_t row = 0; row < vertices_alone.size(); ++row)
    row_of[vertices_alone[row]] = row;
  std::size_t number_on_bar = 0;
  for(Eigen::Index row = 0; row < both.target->rows(); ++row)
  {
    const std::size_t v = vertices[std::size_t(row)];
    if(std::isfinite(both.landmark_fields->distances(row, 0)))
    {
      ++number_on_bar;
      ASSERT_LT(v, n);
      EXPECT_EQ(both.landmark_fields->distances.row(row),
                alone.landmark_fields->distances.row(Eigen::Index(row_of[v])));
      EXPECT_LT((both.target->row(row) - alone.target->row(Eigen::Index(row_of[v]))).norm(), 0.02);
      EXPECT_LT((both.pose.row(Eigen::Index(v)) - alone.pose.row(Eigen::Index(v))).norm(), 0.02);
    }
    else
      EXPECT_EQ(both.target->row(row), both.pose.row(Eigen::Index(v)));
  }
  EXPECT_EQ(number_on_bar, n);
  const Point_matrix rest = shapes::to_matrix(soup.points);
  for(Eigen::Index v = Eigen::Index(n); v < rest.rows(); ++v)
    EXPECT_NEAR((both.pose.row(v) - both.pose.row(Eigen::Index(n) - 1)).norm(),
                (rest.row(v) - rest.row(Eigen::Index(n) - 1)).norm(), 0.01);

  options.given.landmark_fields = both.landmark_fields;
  // the landmarks that were used are on the refined surface
  EXPECT_LT(shapes::relative_rms(pose_of(soup, options).pose, both.pose), 3e-2);
  options.given = both;
  const CP::Result again = pose_of(soup, options);
  EXPECT_EQ(*again.target, *both.target);
  // interpolated at points that were added
  EXPECT_LT(shapes::relative_rms(again.pose, both.pose), 3e-2);
}

// The common vertex of two parts has a row in each of them, with different targets, which lead to the
// same pose again; its pose is that of the larger part.
TEST(Parts_of_complexes, each_has_its_own_target_at_a_common_vertex)
{
  const Tetrahedral_soup soup = with_bar_at_a_vertex(long_bar());
  const std::vector<std::size_t> vertices = vertices_of_rows(soup);
  const std::size_t common = long_bar().points.size() - 1;
  ASSERT_EQ(std::count(vertices.begin(), vertices.end(), common), 2);
  CP::Options options = with(CP::Options::Components::EACH);
  options.registration.energy_tolerance = 1e-8;
  options.registration.move_tolerance = 1e-5;
  const CP::Result first = pose_of(soup, options);
  ASSERT_EQ(first.target->rows(), Eigen::Index(vertices.size()));
  std::vector<Eigen::Index> rows;
  for(std::size_t row = 0; row < vertices.size(); ++row)
    if(vertices[row] == common)
      rows.push_back(Eigen::Index(row));
  EXPECT_GT((first.target->row(rows[0]) - first.target->row(rows[1])).norm(), 1e-3);
  options.given = first;
  const CP::Result second = pose_of(soup, options);
  EXPECT_EQ(*second.target, *first.target);
  // interpolated at points that were added
  EXPECT_LT(shapes::relative_rms(second.pose, first.pose), 1e-2);
}

// Distances are those of the outer surface, so target and scale are those of the full bar; the
// cavity makes it slightly softer. The vertices of the cavity have neither distance nor target, and
// move with the cells.
TEST(Parts_of_complexes, cavity_belongs_to_its_part)
{
  CP::Options options;
  options.return_landmark_fields = true;
  const CP::Result full = pose_of(bar(false), options);
  const double stress = full.summary.target.stress;
  const CP::Result hollow = pose_of(bar(true), options);
  EXPECT_TRUE(hollow.summary.converged());
  EXPECT_EQ(hollow.summary.target.max_geodesic, full.summary.target.max_geodesic);
  EXPECT_EQ(hollow.summary.target.stress, stress);
  EXPECT_EQ(hollow.summary.inverted, 0u);

  std::vector<std::size_t> origin;
  shapes::boundary(bar(false), &origin);
  for(const std::size_t v : origin)
    EXPECT_LT((hollow.pose.row(Eigen::Index(v)) - full.pose.row(Eigen::Index(v))).norm(), 0.03 * 8)
      << v;

  shapes::boundary(bar(true), &origin);
  ASSERT_EQ(hollow.target->rows(), Eigen::Index(origin.size()));
  std::size_t number_inside = 0;
  for(Eigen::Index i = 0; i < hollow.target->rows(); ++i)
    if(!std::isfinite(hollow.landmark_fields->distances(i, 0)))
    {
      ++number_inside;
      EXPECT_EQ(hollow.target->row(i), hollow.pose.row(Eigen::Index(origin[std::size_t(i)])));
    }
  EXPECT_EQ(number_inside, 21u * 5 * 5 - 19u * 3 * 3); // the sides of 20 x 4 x 4 cubes
}

TEST(Parts_of_complexes, several_are_refused)
{
  EXPECT_THROW_WITH(pose_of(two_bars()), std::invalid_argument, "2 connected components");
}

// The same bytes as a separate call.
TEST(Parts_of_complexes, each_is_posed_as_if_alone)
{
  const CP::Result both = pose_of(two_bars(), with(CP::Options::Components::EACH));
  EXPECT_TRUE(both.summary.converged());
  EXPECT_EQ(both.pose.topRows(small_size), pose_of(small_bar()).pose);
  EXPECT_EQ(both.pose.bottomRows(both.pose.rows() - small_size),
            pose_of(merged({}, bar(true), 20.)).pose);
  EXPECT_EQ(both.summary.body.tetrahedra, two_bars().cells.size());
}

// Stiffness has one entry per cell, weights and constraints refer to vertices: each part uses its
// own.
TEST(Parts_of_complexes, options_belong_to_their_part)
{
  CP::Options options = with(CP::Options::Components::EACH);
  const Point_matrix plain = pose_of(two_bars(), options).pose;
  const Eigen::Index n = Eigen::Index(two_bars().cells.size());
  options.stiffness = Eigen::VectorXd::Ones(n);
  options.stiffness.head(Eigen::Index(small_bar().cells.size())).setConstant(4);
  options.constraints.springs = {{0, std::size_t(small_size) - 1, 1., 0.3}};
  CP::Options small_options;
  small_options.stiffness = options.stiffness.head(Eigen::Index(small_bar().cells.size()));
  small_options.constraints.springs = options.constraints.springs;
  const Point_matrix pose = pose_of(two_bars(), options).pose;
  EXPECT_EQ(pose.topRows(small_size), pose_of(small_bar(), small_options).pose);
  EXPECT_EQ(pose.bottomRows(plain.rows() - small_size),
            plain.bottomRows(plain.rows() - small_size));
  EXPECT_GT((pose - plain).norm(), 1e-3);
}

// The largest part has the pose of a separate call, the other one moves without changing its shape;
// the result can be reused.
TEST(Parts_of_complexes, the_largest_carries_the_others)
{
  CP::Options options = with(CP::Options::Components::LARGEST);
  options.return_landmark_fields = true;
  const CP::Result first = pose_of(two_bars(), options);
  EXPECT_EQ(first.pose.bottomRows(first.pose.rows() - small_size),
            pose_of(merged({}, bar(true), 20.)).pose);
  EXPECT_LT(
    shapes::relative_rms(shapes::to_matrix(small_bar().points), first.pose.topRows(small_size)),
    1e-12);
  options.given.landmark_fields = first.landmark_fields;
  EXPECT_EQ(pose_of(two_bars(), options).pose, first.pose);
}

// A few thousand separate cells around a bar keep their six edges: the work per part must not
// depend on the others.
TEST(Parts_of_complexes, thousands)
{
  Tetrahedral_soup soup = small_bar();
  const std::array<std::array<double, 3>, 4> corners
    = {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  constexpr std::size_t number = 4000;
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::size_t n = soup.points.size();
    for(const auto& c : corners)
      soup.points.push_back(
        {{10 + 0.1 * (double(i % 20) + c[0] / 2), 0.1 * (double(i / 20 % 20) + c[1] / 2),
          0.1 * (double(i / 400) + c[2] / 2)}});
    soup.cells.push_back({{n, n + 1, n + 2, n + 3}});
  }
  const Point_matrix rest = shapes::to_matrix(soup.points);
  const Point_matrix pose = pose_of(soup, with(CP::Options::Components::LARGEST)).pose;
  EXPECT_EQ(pose.topRows(small_size), pose_of(small_bar()).pose);
  double largest_change = 0;
  for(Eigen::Index i = small_size; i < rest.rows(); i += 4)
    for(Eigen::Index j = i; j < i + 4; ++j)
      for(Eigen::Index k = i; k < j; ++k)
        largest_change = std::max(largest_change, std::abs((pose.row(j) - pose.row(k)).norm()
                                                           - (rest.row(j) - rest.row(k)).norm()));
  EXPECT_LT(largest_change, 1e-12);
}

// A cell connected through an edge of the bar has no separate pose: it is part of the body. An
// isolated vertex is attached to the nearest cell. Without rounds, in which a small difference of the
// poses may lead to other landmarks.
TEST(Parts_of_complexes, fragments_and_vertices_of_no_cell)
{
  Tetrahedral_soup soup = small_bar();
  const std::size_t n = soup.points.size();
  const auto p = soup.points[n - 1], q = soup.points[n - 2];
  for(const double side : {0.1, 0.2})
    soup.points.push_back(
      {{(p[0] + q[0]) / 2 + side, (p[1] + q[1]) / 2 + 0.3, (p[2] + q[2]) / 2 + 0.1 - side}});
  soup.cells.push_back({{n - 2, n - 1, n, n + 1}});
  soup.points.push_back(soup.points[3]);
  CP::Options options;
  options.number_of_rounds = 0;
  const CP::Result outcome = pose_of(soup, options);
  EXPECT_TRUE(outcome.summary.converged());
  EXPECT_LT((outcome.pose.topRows(small_size) - pose_of(small_bar(), options).pose)
              .rowwise()
              .norm()
              .maxCoeff(),
            0.01);
  EXPECT_LT((outcome.pose.row(small_size) - outcome.pose.row(small_size - 1)).norm(), 1.);
  EXPECT_LT((outcome.pose.row(small_size + 2) - outcome.pose.row(3)).norm(), 1e-9);
}

TEST(Parts_of_complexes, without_boundary)
{
  Tetrahedral_soup twice = shapes::tetrahedral_box(1, 1, 1);
  twice.cells = {twice.cells[0], twice.cells[0]};
  EXPECT_THROW_WITH(pose_of(twice), std::invalid_argument, "the complex has no boundary");
}

// A cell that is there twice has no boundary, and thus no surface to be posed: it follows.
TEST(Parts_of_complexes, closed_part)
{
  Tetrahedral_soup soup = small_bar();
  const std::size_t n = soup.points.size();
  for(const std::array<double, 3>& p :
      {std::array<double, 3>{{9, 0, 0}}, {{10, 0, 0}}, {{9, 1, 0}}, {{9, 0, 1}}})
    soup.points.push_back(p);
  for(int i = 0; i < 2; ++i)
    soup.cells.push_back({{n, n + 1, n + 2, n + 3}});
  for(const auto mode : {CP::Options::Components::AUTOMATIC, CP::Options::Components::REFUSE,
                         CP::Options::Components::LARGEST, CP::Options::Components::EACH})
  {
    const CP::Result result = pose_of(soup, with(mode));
    EXPECT_EQ(result.pose.topRows(small_size), pose_of(small_bar()).pose);
    EXPECT_LT(
      shapes::relative_rms(shapes::to_matrix(soup.points).bottomRows(4), result.pose.bottomRows(4)),
      1e-12);
    ASSERT_EQ(result.summary.followers.size(), 1u);
    EXPECT_TRUE(result.summary.followers[0].is_rigid);
  }
}

// What is in contact follows without sharing a vertex.
TEST(Parts_of_complexes, small_ones_follow)
{
  const Tetrahedral_soup soup
    = merged(bar(true), shapes::tetrahedral_box(2, 2, 2, {{.5, .5, .5}}), -0.6);
  const CP::Result result = pose_of(soup);
  EXPECT_EQ(result.pose.topRows(Eigen::Index(bar(true).points.size())), pose_of(bar(true)).pose);
  EXPECT_EQ(result.summary.followers.size(), 1u);
}

} // namespace test_parts_of_complexes
