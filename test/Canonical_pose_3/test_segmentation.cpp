// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/segmentation/Mirror_symmetry.h"
#include "engine/segmentation/Part_hierarchy.h"
#include "engine/segmentation/Segmented_surface.h"
#include "engine/segmentation/sweep_cuts.h"

#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/k_means_segmentation.h>
#include <CGAL/Canonical_pose_3/segmentation_parts.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "Polygon_soup.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_segmentation {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Polygon_soup;
using Canonical_pose_test::polygon_soup;
using CP::Point_matrix;
using CP::Segmentation_options;
using CP::Segmentation_tree_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Parts = std::vector<std::size_t>;

// Three balls of radius 1 in a row along x, which overlap in circles of radius .2.
constexpr double spacing = 1.96, length = 2 + 2 * spacing;
constexpr double first_neck = 1 + spacing / 2, second_neck = first_neck + spacing;

std::size_t ball_of(const double x) { return x < first_neck ? 0 : x < second_neck ? 1 : 2; }

Canonical_pose_test::Triangle_soup row_of_balls_soup(const std::size_t rings,
                                                     const std::size_t sides)
{
  Canonical_pose_test::Triangle_soup soup = Canonical_pose_test::tube_soup(rings, sides, length, 1);
  for(auto& p : soup.points)
  {
    const double from_center = p[0] - (1 + spacing * double(ball_of(p[0])));
    const double radius = std::sqrt((std::max)(1 - from_center * from_center, 0.));
    p[1] *= radius;
    p[2] *= radius;
  }
  return soup;
}

// A surface of triangles, and a copy of it beside it.
Polygon_soup twice(Polygon_soup soup, const Eigen::RowVector3d& translation)
{
  const std::size_t n = soup.polygons.size(), v = static_cast<std::size_t>(soup.points.rows());
  soup.points.conservativeResize(2 * soup.points.rows(), 3);
  soup.points.bottomRows(soup.points.rows() / 2)
    = soup.points.topRows(soup.points.rows() / 2).rowwise() + translation;
  for(std::size_t f = 0; f < n; ++f)
    soup.polygons.push_back(
      {soup.polygons[f][0] + v, soup.polygons[f][1] + v, soup.polygons[f][2] + v});
  return soup;
}

Polygon_soup row_of_balls() { return polygon_soup(row_of_balls_soup(80, 24)); }

// The row with a small ball at each end, of a five-hundredth of the area; the circles in which these
// overlap with the row are much shorter than the others.
Polygon_soup row_of_balls_with_buttons()
{
  const std::size_t rings_of_ball = 30, sides = 24;
  const double small = .08, half_neck = .2, small_neck = .008;
  std::vector<std::array<double, 2>> circles; // x and radius
  double x = 0;
  const auto add_ball = [&](const double radius, const double left, const double right) {
    const double from = std::asin(left / radius), to = CGAL_PI - std::asin(right / radius);
    x += radius * std::cos(from);
    for(std::size_t i = circles.empty() ? 0 : 1; i <= rings_of_ball; ++i)
    {
      const double angle = from + (to - from) * double(i) / double(rings_of_ball);
      circles.push_back({x - radius * std::cos(angle), radius * std::sin(angle)});
    }
    x = circles.back()[0];
  };
  add_ball(small, 0, small_neck);
  const double start = x;
  add_ball(1, small_neck, half_neck);
  add_ball(1, half_neck, half_neck);
  add_ball(1, half_neck, small_neck);
  add_ball(small, small_neck, 0);
  Canonical_pose_test::Triangle_soup soup
    = Canonical_pose_test::tube_soup(circles.size(), sides, 1, 1);
  for(std::size_t i = 0; i < circles.size(); ++i)
    for(std::size_t j = 0; j < sides; ++j)
    {
      auto& p = soup.points[i * sides + j];
      p = {{circles[i][0] - start, circles[i][1] * p[1], circles[i][1] * p[2]}};
    }
  soup.points[circles.size() * sides] = {{circles.front()[0] - start, 0., 0.}};
  soup.points[circles.size() * sides + 1] = {{circles.back()[0] - start, 0., 0.}};
  return polygon_soup(soup);
}

Eigen::RowVector3d centroid(const Polygon_soup& soup, const std::size_t f)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for(const std::size_t v : soup.polygons[f])
    sum += soup.points.row(static_cast<Eigen::Index>(v));
  return sum / static_cast<double>(soup.polygons[f].size());
}

double centroid_x(const Polygon_soup& soup, const std::size_t f) { return centroid(soup, f)[0]; }

// The faces that are not near a neck belong to the ball they lie on, and each ball is one part.
void expect_balls(const Polygon_soup& soup, const Parts& parts)
{
  const double half_neck = .2;
  std::set<std::size_t> parts_of_ball[3];
  ASSERT_EQ(parts.size(), soup.polygons.size());
  for(std::size_t f = 0; f < parts.size(); ++f)
  {
    const double x = centroid_x(soup, f);
    if(std::abs(x - first_neck) > half_neck && std::abs(x - second_neck) > half_neck)
      parts_of_ball[ball_of(x)].insert(parts[f]);
  }
  std::set<std::size_t> all;
  for(const std::set<std::size_t>& own : parts_of_ball)
  {
    EXPECT_EQ(own.size(), 1u);
    all.insert(own.begin(), own.end());
  }
  EXPECT_EQ(all.size(), 3u);
}

std::size_t number_of(const Parts& parts)
{
  return parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1;
}

// A box that is open at the top, with thin walls and a handle: the unit cubes of a grid. The cavity is
// from 1 to 19 in x and y, and begins at 1 in z; the handle begins at 20 in x.
constexpr int cup_width = 20, cup_height = 16, handle_width = 6;

bool is_in_cup(const int x, const int y, const int z)
{
  const auto is_inside
    = [](const int i, const int begin, const int end) { return i >= begin && i < end; };
  const int w = cup_width;
  if(is_inside(x, 0, w) && is_inside(y, 0, w) && is_inside(z, 0, cup_height))
    return z == 0 || x == 0 || x == w - 1 || y == 0 || y == w - 1;
  return is_inside(x, w, w + handle_width) && is_inside(y, 9, 11) && is_inside(z, 4, 13)
         && !(x < w + handle_width - 2 && is_inside(z, 6, 11));
}

Polygon_soup cup()
{
  Polygon_soup result;
  std::vector<Eigen::Vector3d> points;
  std::map<std::array<int, 3>, std::size_t> vertices;
  const auto add_square = [&](std::array<int, 3> corner, const std::size_t axis,
                              const bool is_upper) {
    corner[axis] += int(is_upper);
    std::vector<std::size_t> square;
    for(const auto& [u, v] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
    {
      std::array<int, 3> p = corner;
      p[(axis + 1) % 3] += u;
      p[(axis + 2) % 3] += v;
      const auto [it, is_new] = vertices.emplace(p, points.size());
      if(is_new)
        points.emplace_back(p[0], p[1], p[2]);
      square.push_back(it->second);
    }
    if(!is_upper)
      std::reverse(square.begin(), square.end());
    result.polygons.push_back(square);
  };
  for(int x = 0; x < cup_width + handle_width; ++x)
    for(int y = 0; y < cup_width; ++y)
      for(int z = 0; z < cup_height; ++z)
        if(is_in_cup(x, y, z))
          for(std::size_t axis = 0; axis < 3; ++axis)
            for(const int step : {-1, 1})
            {
              std::array<int, 3> neighbor = {x, y, z};
              neighbor[axis] += step;
              if(!is_in_cup(neighbor[0], neighbor[1], neighbor[2]))
                add_square({x, y, z}, axis, step > 0);
            }
  result.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for(std::size_t v = 0; v < points.size(); ++v)
    result.points.row(static_cast<Eigen::Index>(v)) = points[v];
  return result;
}

// The cup with its cavity turned out, so that it encloses more than twice the volume, and with a neck
// where the rim was: the cheapest cut of this solid divides the wall of the cup.
Point_matrix turned_out(Point_matrix points)
{
  for(Eigen::Index v = 0; v < points.rows(); ++v)
  {
    auto p = points.row(v);
    if((p.array() >= 1).all() && (p.head(2).array() <= cup_width - 1).all())
      p[2] = 2 * cup_height - p[2];
    const double scale = .3 + .7 * (std::min)(1., std::abs(p[2] - cup_height) / 6);
    p.head(2) = scale * (p.head(2).array() - cup_width / 2.);
  }
  return points;
}

Segmentation_options with_parts(const std::size_t number)
{
  Segmentation_options options;
  options.number_of_parts = number;
  return options;
}

Point_matrix no_pose() { return Point_matrix(0, 3); }

class Segmentation : public testing::TestWithParam<bool>
{
public:
  // By consensus or by sweep cuts.
  Segmentation_tree_3 tree(const Polygon_soup& soup, const Segmentation_options& options,
                           const Point_matrix& pose = no_pose()) const
  {
    return GetParam() ? CP::consensus_segmentation_tree(soup.points, soup.polygons, pose, options)
                      : CP::sweep_segmentation_tree(soup.points, soup.polygons, pose, options);
  }
};

// The necks are the only concave regions, and the shortest boundaries by far.
TEST_P(Segmentation, balls_are_parts)
{
  const Polygon_soup soup = row_of_balls();
  expect_balls(soup, tree(soup, with_parts(3)).parts());
}

// The cuts around the buttons are the cheapest ones, but they are too small for parts.
TEST(Consensus_segmentation, buttons_are_no_parts)
{
  const Polygon_soup soup = row_of_balls_with_buttons();
  const Segmentation_tree_3 tree
    = CP::consensus_segmentation_tree(soup.points, soup.polygons, no_pose(), with_parts(3));
  EXPECT_EQ(tree.number_of_parts, 3u);
  expect_balls(soup, tree.parts());
}

// A path of patches. By their costs, the cut around the small patch at the end is the best one; without
// it, that of patches 0 and 1 from the others. The costs are exact.
TEST(Sweep_cuts, sides_are_not_smaller_than_the_least_area)
{
  CP::internal::Patch_graph graph;
  graph.areas.resize(5);
  graph.areas << .25, .25, .25, .246, .004;
  graph.edges = {{0, 1, .4, 4}, {1, 2, .1, 1}, {2, 3, .4, 4}, {3, 4, .001, .01}};
  const auto partition = [&](const double least_area) {
    return CP::internal::sweep_partition(graph, {.5, least_area}, 2, 2, 0);
  };
  const auto any = partition(0), large = partition(.01);
  EXPECT_EQ(any.part_of_patch[0], any.part_of_patch[3]);
  EXPECT_NE(any.part_of_patch[3], any.part_of_patch[4]);
  EXPECT_NEAR(any.costs[0], .001 / std::sqrt(.004), 1e-12);
  EXPECT_EQ(large.part_of_patch[0], large.part_of_patch[1]);
  EXPECT_NE(large.part_of_patch[1], large.part_of_patch[2]);
  EXPECT_EQ(large.part_of_patch[2], large.part_of_patch[4]);
  EXPECT_NEAR(large.costs[0], .1 / std::sqrt(.5), 1e-12);
}

// A small patch that is connected to nothing is a part, but does not count.
TEST(Sweep_cuts, small_components_do_not_count)
{
  CP::internal::Patch_graph graph;
  graph.areas.resize(3);
  graph.areas << .5, .496, .004;
  graph.edges = {{0, 1, .1, 1}};
  const auto partition = CP::internal::sweep_partition(graph, {.5, .01}, 2, 2, 0);
  EXPECT_EQ(partition.number_of_large_parts, 2u);
  EXPECT_EQ(partition.number_of_parts, 3u);
}

TEST_P(Segmentation, number_of_parts_is_determined)
{
  const Polygon_soup soup = row_of_balls();
  const Segmentation_tree_3 result = tree(soup, with_parts(0));
  EXPECT_EQ(result.number_of_parts, 3u);
  expect_balls(soup, result.parts());
}

// Nothing of these shapes is concave, and none has a neck: one cut is as good as the next, so there is
// no reason for any.
TEST_P(Segmentation, what_has_no_parts_is_one)
{
  using Canonical_pose_test::tube_soup;
  const auto number_of_polygons = [&](const Polygon_soup& polygons) {
    const Segmentation_tree_3 result = tree(polygons, with_parts(0));
    EXPECT_EQ(result.number_of_parts, number_of(result.parts()));
    return result.number_of_parts;
  };
  const auto number = [&](const Canonical_pose_test::Triangle_soup& soup) {
    return number_of_polygons(polygon_soup(soup));
  };
  EXPECT_EQ(number(tube_soup(2, 8, 5, .5)), 1u);
  EXPECT_EQ(number(tube_soup(3, 24, 6, .5)), 1u);
  EXPECT_EQ(number(tube_soup(3, 48, 6, .5)), 1u);
  EXPECT_EQ(number(tube_soup(4, 6, 10, .5)), 1u);
  EXPECT_EQ(number(tube_soup(4, 24, 6, .5)), 1u);
  EXPECT_EQ(number(tube_soup(25, 16, 5, .5)), 1u);
  EXPECT_EQ(number(tube_soup(80, 12, 20, .5)), 1u);
  EXPECT_EQ(number(tube_soup(200, 12, 50, .5)), 1u);
  EXPECT_EQ(number(tube_soup(500, 8, 200, .5)), 1u);
  EXPECT_EQ(number(Canonical_pose_test::plane_grid_soup(160, 4, 40, 1)), 1u);
  EXPECT_EQ(number(Canonical_pose_test::icosphere_soup(3, 1)), 1u);
  EXPECT_EQ(number(Canonical_pose_test::torus_soup(60, 20, 1, .3)), 1u);
  EXPECT_EQ(number_of_polygons(twice(polygon_soup(tube_soup(80, 12, 20, .5)), {0, 5, 0})), 2u);
}

// The teeth of a comb are bars that meet its back at concave edges. Each is cut off, although within
// the comb most cuts have others as good beside them.
TEST_P(Segmentation, teeth_of_a_comb_are_parts)
{
  constexpr double back = 6, length_of_teeth = 10, period = 4, width = 2;
  const Canonical_pose_test::Tetrahedral_soup box
    = Canonical_pose_test::tetrahedral_box(18, 16, 2, {18, back + length_of_teeth, 2});
  Canonical_pose_test::Tetrahedral_soup comb = box;
  comb.cells.clear();
  for(const auto& cell : box.cells)
  {
    double x = 0, y = 0;
    for(const std::size_t v : cell)
    {
      x += box.points[v][0] / 4;
      y += box.points[v][1] / 4;
    }
    if(y < back || std::fmod(x, period) < width)
      comb.cells.push_back(cell);
  }
  const Polygon_soup soup = polygon_soup(Canonical_pose_test::boundary(comb));
  const Parts parts = tree(soup, with_parts(0)).parts();
  std::vector<std::set<std::size_t>> of_tooth(5);
  for(std::size_t f = 0; f < parts.size(); ++f)
  {
    const auto v = static_cast<Eigen::Index>(soup.polygons[f][0]);
    if(soup.points(v, 1) > back + length_of_teeth - width)
      of_tooth[static_cast<std::size_t>(soup.points(v, 0) / period)].insert(parts[f]);
  }
  std::set<std::size_t> all;
  for(const std::set<std::size_t>& own : of_tooth)
  {
    EXPECT_EQ(own.size(), 1u);
    all.insert(own.begin(), own.end());
  }
  EXPECT_EQ(all.size(), 5u);
}

// Two parts of a row of three balls are one ball and two balls.
TEST_P(Segmentation, segmentations_of_a_tree_are_nested)
{
  const Polygon_soup soup = row_of_balls();
  const Segmentation_tree_3 result = tree(soup, with_parts(3));
  EXPECT_EQ(result.least_number_of_parts(), 1u);
  ASSERT_GT(result.number_of_leaves, 5u);
  for(std::size_t k = 1; k <= result.number_of_leaves; ++k)
  {
    const Parts parts = result.parts(k), more = result.parts(k + 1);
    EXPECT_EQ(number_of(parts), k);
    std::vector<std::set<std::size_t>> owners(number_of(more));
    for(std::size_t f = 0; f < parts.size(); ++f)
      owners[more[f]].insert(parts[f]);
    for(const std::set<std::size_t>& owner : owners)
      EXPECT_EQ(owner.size(), 1u) << k;
  }
  for(std::size_t i = 1; i < result.merges.size(); ++i)
    EXPECT_LE(result.merges[i - 1].cost, result.merges[i].cost);
}

// Rotation, translation, scale and another order of the faces change numbers in their last digits,
// and the order of ties; the balls remain.
TEST_P(Segmentation, follows_motions_scale_and_relabeling)
{
  Polygon_soup soup = row_of_balls();
  const Polygon_soup before = soup;
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for(const double scale : {1e-9, 1., 1e12})
  {
    soup.points
      = scale * ((before.points * rotation.transpose()).rowwise() + Eigen::RowVector3d(5, -3, 2));
    soup.polygons.assign(before.polygons.rbegin(), before.polygons.rend());
    Parts parts = tree(soup, with_parts(3)).parts();
    std::reverse(parts.begin(), parts.end());
    expect_balls(before, parts);
  }
}

TEST_P(Segmentation, does_not_depend_on_threads)
{
  const Polygon_soup soup = row_of_balls();
  Segmentation_options options = with_parts(4);
  options.number_of_threads = 1;
  const Segmentation_tree_3 one = tree(soup, options);
  options.number_of_threads = 2;
  const Segmentation_tree_3 two = tree(soup, options);
  EXPECT_EQ(one.leaf_of_face, two.leaf_of_face);
  ASSERT_EQ(one.merges.size(), two.merges.size());
  for(std::size_t i = 0; i < one.merges.size(); ++i)
    EXPECT_EQ(one.merges[i].cost, two.merges[i].cost);
}

// A pose that is the input adds nothing but votes.
TEST_P(Segmentation, takes_a_pose)
{
  const Polygon_soup soup = row_of_balls();
  expect_balls(soup, tree(soup, with_parts(3), soup.points).parts());
}

// A pose that is squeezed flat, or inside out, does not vote: the parts are those without a pose.
TEST(Consensus_segmentation, collapsed_poses_do_not_vote)
{
  const Polygon_soup soup = row_of_balls();
  const auto leaves = [&](const Point_matrix& pose) {
    return CP::consensus_segmentation_tree(soup.points, soup.polygons, pose, with_parts(4))
      .leaf_of_face;
  };
  const std::vector<std::size_t> without = leaves(no_pose());
  EXPECT_EQ(leaves(soup.points * Eigen::Vector3d(1, 1, .01).asDiagonal()), without);
  EXPECT_EQ(leaves(soup.points * Eigen::Vector3d(1, 1, -1).asDiagonal()), without);
  EXPECT_NE(leaves(soup.points * Eigen::Vector3d(1.3, 1, .8).asDiagonal()), without);
}

// A pose that encloses what was outside does not vote either, unless the number of parts is given.
TEST(Consensus_segmentation, swollen_poses_do_not_determine_the_number_of_parts)
{
  const Polygon_soup soup = cup();
  const auto leaves = [&](const std::size_t number, const Point_matrix& pose) {
    return CP::consensus_segmentation_tree(soup.points, soup.polygons, pose, with_parts(number))
      .leaf_of_face;
  };
  EXPECT_EQ(leaves(0, turned_out(soup.points)), leaves(0, no_pose()));
  EXPECT_NE(leaves(2, turned_out(soup.points)), leaves(2, no_pose()));
}

// More than 25 000 faces: parts are computed on a simplified copy, and each face has one. Boundaries
// are smoothed on the surface itself: they are little longer than the circles of the necks, which are
// the shortest possible ones.
TEST_P(Segmentation, large_surfaces_are_simplified)
{
  const Polygon_soup soup = polygon_soup(row_of_balls_soup(300, 60));
  ASSERT_GT(soup.polygons.size(), 25000u);
  const Parts parts = tree(soup, with_parts(3)).parts();
  expect_balls(soup, parts);
  const double length_of_necks = 4 * CGAL_PI * .2;
  double measured = 0;
  for(const auto& part : CP::segmentation_parts(soup.points, soup.polygons, parts))
    for(const auto& neighbor : part.neighbors)
      measured += neighbor.boundary_length / 2; // each boundary belongs to two parts
  EXPECT_NEAR(measured, length_of_necks, .1 * length_of_necks);
}

// Votes that are all the same agree, even if they are not the only ones possible; votes that divide the
// balls in two at random places do not.
TEST(Part_hierarchy, agreement_is_that_of_votes)
{
  const Polygon_soup soup = row_of_balls();
  const CP::internal::Segmented_surface surface(soup.points, soup.polygons, no_pose());
  const CP::internal::Face_graph graph = surface.graph();
  const CP::internal::Patches patches
    = CP::internal::farthest_point_patches(graph, CP::internal::edge_distances(graph), 60, 0);
  const auto n = static_cast<Eigen::Index>(patches.size());
  const auto x = [&](const Eigen::Index p) {
    return centroid_x(soup, patches.centers[static_cast<std::size_t>(p)]);
  };
  Eigen::MatrixXd same(n, n), by_chance(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
    for(Eigen::Index j = 0; j < n; ++j)
    {
      same(i, j) = ball_of(x(i)) == ball_of(x(j)) ? 1 : 0;
      by_chance(i, j) = 1 - std::abs(x(i) - x(j)) / length;
    }
  using CP::internal::Part_hierarchy;
  EXPECT_NEAR(Part_hierarchy(graph, patches, same).agreement(3), 1, 1e-9);
  EXPECT_LT(Part_hierarchy(graph, patches, by_chance).agreement(3), .4);
  EXPECT_LT(Part_hierarchy(graph, patches, Eigen::MatrixXd::Constant(n, n, .5)).agreement(3), .1);
}

// A ball with limbs along the given vectors, the thinner the larger the exponent.
Polygon_soup ball_with_limbs(const std::vector<Eigen::Vector3d>& limbs, const double exponent = 12)
{
  Polygon_soup result = polygon_soup(Canonical_pose_test::icosphere_soup(4, 1));
  for(Eigen::Index v = 0; v < result.points.rows(); ++v)
  {
    double radius = 1;
    for(const Eigen::Vector3d& limb : limbs)
    {
      const double cosine = (std::max)(0., result.points.row(v).dot(limb.normalized()));
      radius += limb.norm() * std::pow(cosine, exponent);
    }
    result.points.row(v) *= radius;
  }
  return result;
}

// The first shape is symmetric with respect to the plane y = 0 only: up to the size of a patch (300 on an
// area of about 30, so with a radius of about .2), the image of a patch is its reflection. In the
// second one, no reflection maps limbs to limbs of about the same length.
TEST(Mirror_symmetry, maps_patches_to_their_reflections)
{
  const auto symmetry = [](const Polygon_soup& soup, Eigen::VectorXd& y) {
    const CP::internal::Segmented_surface surface(soup.points, soup.polygons, no_pose());
    const CP::internal::Face_graph graph = surface.graph();
    const CP::internal::Patches patches
      = CP::internal::farthest_point_patches(graph, CP::internal::edge_distances(graph), 300, 0);
    y = CP::internal::patch_means(graph, patches, graph.centroids,
                                  CP::internal::patch_areas(graph, patches))
          .col(1);
    return CP::internal::Mirror_symmetry(graph, patches);
  };
  Eigen::VectorXd y;
  const auto mirror
    = symmetry(ball_with_limbs({{2, 1, 1}, {2, -1, 1}, {-1, 2, 0}, {-1, -2, 0}, {.5, 0, -1}}), y);
  EXPECT_LT(mirror.distortion(), .09);
  const Eigen::MatrixXd values = y.replicate(1, y.size());
  const Eigen::MatrixXd sums = values + mirror.mirrored(values);
  const double size = y.maxCoeff() - y.minCoeff();
  EXPECT_LT(sums.cwiseAbs().maxCoeff(), .1 * size);

  EXPECT_GT(
    symmetry(ball_with_limbs({{0, 0, 3}, {0, 0, -1}, {4, 0, 0}, {-1, 1.7, 0}, {-.35, -.6, 0}}), y)
      .distortion(),
    .09);
}

// The fins have about a hundredth of the area each. In a shape of limbs, such small parts are not cut off,
// and this body is divided instead. But most of its points see each other, so it is one part.
TEST(Consensus_segmentation, fins_of_a_body_are_parts)
{
  const std::vector<Eigen::Vector3d> fins = {{.6, 0, 0}, {-.6, 0, .2}, {0, .6, -.2}, {0, -.6, .2}};
  Polygon_soup soup = ball_with_limbs(fins, 120);
  soup.points.col(2) *= 3;
  const Parts parts
    = CP::consensus_segmentation_tree(soup.points, soup.polygons, no_pose(), with_parts(5)).parts();
  std::set<std::size_t> parts_of_body;
  std::array<std::set<std::size_t>, 4> parts_of_fin;
  for(std::size_t f = 0; f < parts.size(); ++f)
  {
    const Eigen::RowVector3d point
      = centroid(soup, f).array() / Eigen::Array3d(1, 1, 3).transpose();
    double largest_cosine = 0;
    for(std::size_t i = 0; i < fins.size(); ++i)
    {
      const double along = point.dot(fins[i].normalized());
      largest_cosine = (std::max)(largest_cosine, along / point.norm());
      if(along > 1.3)
        parts_of_fin[i].insert(parts[f]);
    }
    if(largest_cosine < .8)
      parts_of_body.insert(parts[f]);
  }
  ASSERT_EQ(parts_of_body.size(), 1u);
  std::set<std::size_t> all = parts_of_body;
  for(const std::set<std::size_t>& own : parts_of_fin)
  {
    EXPECT_EQ(own.size(), 1u);
    all.insert(own.begin(), own.end());
  }
  EXPECT_EQ(all.size(), 5u);
}

TEST_P(Segmentation, each_component_has_a_part)
{
  const Polygon_soup soup
    = twice(polygon_soup(Canonical_pose_test::icosphere_soup(2, 1)), {10, 0, 0});
  const std::size_t n = soup.polygons.size() / 2;
  const Segmentation_tree_3 result = tree(soup, with_parts(1));
  EXPECT_EQ(result.least_number_of_parts(), 2u);
  const Parts parts = result.parts();
  for(std::size_t f = 0; f < 2 * n; ++f)
    EXPECT_EQ(parts[f], f < n ? 0u : 1u);
}

// A row of balls among small tetrahedra, more than there are patches. Each of these is a part, and the
// row is divided as it is without them: they take nothing of the area that matters.
TEST_P(Segmentation, small_components_are_parts)
{
  constexpr std::size_t number_of_small = 400;
  constexpr double size = .02;
  const Polygon_soup row = row_of_balls();
  Polygon_soup soup = row;
  const Eigen::Index n = row.points.rows();
  soup.points.conservativeResize(n + 4 * Eigen::Index(number_of_small), 3);
  for(std::size_t i = 0; i < number_of_small; ++i)
  {
    const std::size_t v = std::size_t(n) + 4 * i;
    const Eigen::RowVector3d corner(double(i % 20), 3 + double(i / 20), 0);
    for(std::size_t k = 0; k < 4; ++k)
      soup.points.row(Eigen::Index(v + k)) = corner;
    for(Eigen::Index k = 0; k < 3; ++k)
      soup.points(Eigen::Index(v) + 1 + k, k) += size;
    for(const std::vector<std::size_t>& t : std::vector<std::vector<std::size_t>>{
          {v, v + 2, v + 1}, {v, v + 1, v + 3}, {v, v + 3, v + 2}, {v + 1, v + 2, v + 3}})
      soup.polygons.push_back(t);
  }
  for(const std::size_t requested : {std::size_t(0), 3 + number_of_small})
  {
    const Segmentation_tree_3 result = tree(soup, with_parts(requested));
    EXPECT_EQ(result.number_of_parts, 3 + number_of_small);
    EXPECT_EQ(result.least_number_of_parts(), 1 + number_of_small);
    Parts parts = result.parts();
    ASSERT_EQ(parts.size(), soup.polygons.size());
    EXPECT_EQ(number_of(parts), 3 + number_of_small);
    for(std::size_t f = row.polygons.size(); f < parts.size(); ++f)
      EXPECT_EQ(parts[f], 3 + (f - row.polygons.size()) / 4);
    parts.resize(row.polygons.size());
    expect_balls(row, parts);
    EXPECT_EQ(number_of(result.parts(1)), 1 + number_of_small);
  }
}

// An open surface of quadrangles, with a face that is there twice, and one without area.
TEST_P(Segmentation, any_surface_gets_a_part_per_face)
{
  Polygon_soup soup;
  soup.points.resize(36, 3);
  for(Eigen::Index i = 0; i < 36; ++i)
    soup.points.row(i) << double(i % 6), double(i / 6), 0;
  for(std::size_t y = 0; y < 5; ++y)
    for(std::size_t x = 0; x < 5; ++x)
      soup.polygons.push_back({6 * y + x, 6 * y + x + 1, 6 * y + x + 7, 6 * y + x + 6});
  soup.polygons.push_back(soup.polygons.front());
  soup.polygons.push_back({0, 1, 2});
  const Parts parts = tree(soup, with_parts(2)).parts();
  ASSERT_EQ(parts.size(), soup.polygons.size());
  EXPECT_EQ(number_of(parts), 2u);
  EXPECT_EQ(parts[25], parts[0]);
}

TEST_P(Segmentation, small_and_bad_input)
{
  Polygon_soup triangle;
  triangle.points.resize(3, 3);
  triangle.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  triangle.polygons = {{0, 1, 2}};
  EXPECT_EQ(tree(triangle, with_parts(0)).parts(), Parts(1, 0));
  EXPECT_EQ(tree(triangle, with_parts(1000)).parts(), Parts(1, 0));

  Polygon_soup bad = triangle;
  bad.points(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(tree(bad, with_parts(1)), std::invalid_argument);
  bad = triangle;
  bad.polygons[0][2] = 3;
  EXPECT_THROW(tree(bad, with_parts(1)), std::invalid_argument);
  bad.polygons.clear();
  EXPECT_THROW(tree(bad, with_parts(1)), std::invalid_argument);
  EXPECT_THROW(tree(triangle, with_parts(1), Point_matrix::Zero(2, 3)), std::invalid_argument);
  EXPECT_THROW(tree(triangle, with_parts(1), Point_matrix::Constant(3, 3, INFINITY)),
               std::invalid_argument);
  EXPECT_THROW(tree(triangle, with_parts(1), Point_matrix::Zero(3, 3)), std::invalid_argument);
  Segmentation_options options;
  options.number_of_threads = -1;
  EXPECT_THROW(tree(triangle, options), std::invalid_argument);

  const Polygon_soup ball = polygon_soup(Canonical_pose_test::icosphere_soup(0, 1));
  EXPECT_LE(number_of(tree(ball, with_parts(1000)).parts()), 20u);
}

INSTANTIATE_TEST_SUITE_P(methods, Segmentation, testing::Values(true, false),
                         [](const auto& info) { return info.param ? "consensus" : "sweep"; });

template <class Mesh>
Parts parts_of_mesh(const Mesh& mesh)
{
  auto ids = get(CGAL::dynamic_face_property_t<int>(), mesh);
  EXPECT_EQ(CP::consensus_segmentation(mesh, get(CGAL::vertex_point, mesh), ids, with_parts(3)),
            3u);
  EXPECT_EQ(CP::segmentation_parts(mesh, ids).size(), 3u);
  EXPECT_EQ(CP::sweep_segmentation(mesh, ids, with_parts(2)), 2u);
  EXPECT_EQ(CP::k_means_segmentation(mesh, get(CGAL::vertex_point, mesh), ids, with_parts(4)), 4u);
  CP::consensus_segmentation(mesh, ids, with_parts(3));
  Parts result;
  for(const auto f : faces(mesh))
    result.push_back(static_cast<std::size_t>(get(ids, f)));
  return result;
}

TEST(Segmentation_of_meshes, two_models_of_face_graphs)
{
  const Canonical_pose_test::Triangle_soup soup = row_of_balls_soup(80, 24);
  const Parts of_surface_mesh
    = parts_of_mesh(Canonical_pose_test::to_mesh<CGAL::Surface_mesh<Kernel::Point_3>>(soup));
  expect_balls(polygon_soup(soup), of_surface_mesh);
  EXPECT_EQ(
    number_of(parts_of_mesh(Canonical_pose_test::to_mesh<CGAL::Polyhedron_3<Kernel>>(soup))), 3u);
}

// CGAL's graph cut ends the process if a node has more than 1023 arcs.
TEST(Consensus_segmentation, many_faces_of_an_edge)
{
  constexpr std::size_t n = 1500;
  CP::Point_matrix points(n + 2, 3);
  points.row(0) << 0, 0, 0;
  points.row(1) << 0, 0, 1;
  std::vector<std::vector<std::size_t>> faces;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double a = 2 * CGAL_PI * double(i) / double(n);
    points.row(Eigen::Index(i) + 2) << std::cos(a), std::sin(a), .5;
    faces.push_back({0, 1, i + 2});
  }
  EXPECT_EQ(CP::consensus_segmentation_tree(points, faces, no_pose(), with_parts(2)).parts().size(),
            n);
}

// Balls of the same size at equal distances: their centers are the best ones.
TEST(K_means_segmentation, finds_balls)
{
  const Polygon_soup soup = row_of_balls();
  for(const CP::K_means_weights weights :
      {CP::K_means_weights::VERTICES, CP::K_means_weights::AREAS})
    expect_balls(soup, CP::k_means_parts(soup.points, soup.polygons, with_parts(3), weights));
  EXPECT_THROW(CP::k_means_parts(soup.points, soup.polygons, with_parts(0)), std::invalid_argument);
  Segmentation_options bad = with_parts(3);
  bad.number_of_threads = -1;
  EXPECT_THROW(CP::k_means_parts(soup.points, soup.polygons, bad), std::invalid_argument);
  EXPECT_THROW(CP::k_means_parts(soup.points, {}, with_parts(3)), std::invalid_argument);
  EXPECT_THROW(CP::k_means_parts(soup.points, {{0, 1, 1000000}}, with_parts(3)),
               std::invalid_argument);
}

// Two unit squares with a common side, of one quadrangle and of two triangles.
TEST(Segmentation_parts, measures_are_exact)
{
  Point_matrix points(6, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0;
  const auto parts
    = CP::segmentation_parts(points, {{0, 1, 4, 3}, {1, 2, 5}, {1, 5, 4}}, {0, 1, 1});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].number_of_faces, 1u);
  EXPECT_EQ(parts[1].number_of_faces, 2u);
  for(std::size_t part = 0; part < 2; ++part)
  {
    EXPECT_DOUBLE_EQ(parts[part].area, 1);
    ASSERT_EQ(parts[part].neighbors.size(), 1u);
    EXPECT_EQ(parts[part].neighbors[0].part, 1 - part);
    EXPECT_DOUBLE_EQ(parts[part].neighbors[0].boundary_length, 1);
    EXPECT_EQ(parts[part].neighbors[0].boundary_centroid, Eigen::RowVector3d(1, .5, 0));
  }
}

} // namespace test_segmentation
