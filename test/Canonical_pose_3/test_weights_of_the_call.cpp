// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights and stiffness of the one call.

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/property_values.h>

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
#include <vector>

namespace test_weights_of_the_call {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using Eigen::VectorXd;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

VectorXd ones(const shapes::Triangle_soup& soup)
{
  return VectorXd::Ones(static_cast<Eigen::Index>(soup.points.size()));
}

// Constant weights of 2 and stiffness 1 have no effect, bit by bit; stiffness 4 is equivalent to
// twice the detail length up to rounding, which is amplified by ties of landmarks in rounds, and by
// untangling cells: this is compared without them.
TEST(Weights_of_surfaces, constants)
{
  const shapes::Triangle_soup bar = shapes::bent_bar();
  CP::Options options, single;
  single.number_of_rounds = 0;
  single.registration.injective = false;
  const Point_matrix with_rounds = shapes::pose_of(bar, options).pose;
  options.matching_weights = 2 * ones(bar);
  options.stiffness = ones(bar);
  EXPECT_TRUE(shapes::pose_of(bar, options).pose == with_rounds);

  options = single;
  const Point_matrix pose = shapes::pose_of(bar, options).pose;
  options.matching_weights = 2 * ones(bar);
  options.stiffness = ones(bar);
  EXPECT_TRUE(shapes::pose_of(bar, options).pose == pose);
  options.stiffness *= 4;
  const Point_matrix stiff = shapes::pose_of(bar, options).pose;
  options = single;
  options.registration.detail_length *= 2;
  EXPECT_LT((shapes::pose_of(bar, options).pose - stiff).norm(), 1e-9);
  EXPECT_GT((stiff - pose).norm(), 1e-3);
}

// Each component has the factors of its own vertices: those of one bar have no influence on the
// other. The factors of isolated vertices do not count.
TEST(Weights_of_surfaces, belong_to_the_vertices_of_a_component)
{
  shapes::Triangle_soup bars = shapes::two_bars();
  const Eigen::Index n = static_cast<Eigen::Index>(bars.points.size() / 2);
  CP::Options options = shapes::each_component();
  const Point_matrix pose = shapes::pose_of(bars, options).pose;
  options.stiffness = ones(bars);
  options.matching_weights = ones(bars);
  options.stiffness.tail(n).setConstant(10);
  options.matching_weights.tail(n) = VectorXd::LinSpaced(n, 0, 5);
  const Point_matrix changed = shapes::pose_of(bars, options).pose;
  EXPECT_TRUE(changed.topRows(n) == pose.topRows(n));
  EXPECT_GT((changed - pose).bottomRows(n).norm(), 1e-3);

  shapes::Triangle_soup with_isolated = shapes::bent_bar();
  with_isolated.points.insert(with_isolated.points.begin(), {{1, 2, 3}});
  for(auto& t : with_isolated.triangles)
    for(std::size_t& v : t)
      ++v;
  options = CP::Options();
  options.stiffness = options.matching_weights = ones(with_isolated);
  options.stiffness.tail(n) = options.matching_weights.tail(n) = VectorXd::LinSpaced(n, 1, 9);
  const Point_matrix one = shapes::pose_of(with_isolated, options).pose;
  options.stiffness[0] = options.matching_weights[0] = 1e6;
  EXPECT_TRUE(shapes::pose_of(with_isolated, options).pose == one);
}

// Factors follow their vertices: with all vertices in reverse order, the pose is the same up to
// ties and rounding. In a single registration, which is what the factors belong to.
TEST(Weights_of_surfaces, do_not_depend_on_the_order_of_the_vertices)
{
  shapes::Triangle_soup bar = shapes::bent_bar();
  const std::size_t n = bar.points.size();
  CP::Options options;
  options.number_of_rounds = 0;
  options.registration.injective = false;
  options.stiffness = VectorXd::LinSpaced(static_cast<Eigen::Index>(n), 1, 9).array().square();
  options.matching_weights = options.stiffness.cwiseInverse();
  const Point_matrix pose = shapes::pose_of(bar, options).pose;
  std::reverse(bar.points.begin(), bar.points.end());
  for(auto& t : bar.triangles)
    for(std::size_t& v : t)
      v = n - 1 - v;
  const Point_matrix other = shapes::pose_of(bar, options).pose;
  options.stiffness.reverseInPlace();
  options.matching_weights.reverseInPlace();
  const Point_matrix reversed = shapes::pose_of(bar, options).pose;
  const auto relative_rms = [&](const Point_matrix& of_reversed) {
    const Point_matrix difference = of_reversed.colwise().reverse() - pose;
    return std::sqrt(difference.rowwise().squaredNorm().mean()) / shapes::radius_of_gyration(pose);
  };
  EXPECT_LT(relative_rms(reversed), 4e-3); // as without factors, see test_invariance.cpp
  EXPECT_GT(relative_rms(other), 2e-2);
}

// For a complex, stiffness is per cell, weights are per vertex; those of interior vertices do not
// count. In a single registration, as above.
TEST(Weights_of_complexes, are_those_of_cells_and_vertices)
{
  const shapes::Tetrahedral_soup soup = shapes::tetrahedral_bent_bar(12, 2, 2, 2.);
  CP::Indexed_tetrahedra_3<Kernel::Point_3> complex;
  for(const auto& p : soup.points)
    complex.points.emplace_back(p[0], p[1], p[2]);
  complex.cells = soup.cells;
  const auto pose_of = [&](const CP::Options& options) {
    std::vector<Kernel::Point_3> pose(complex.points.size());
    CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), options);
    return shapes::to_matrix(pose);
  };
  CP::Options single;
  single.number_of_rounds = 0;
  single.registration.injective = false;
  CP::Options options = single;
  const Point_matrix plain = pose_of(options);
  options.stiffness = VectorXd::Constant(static_cast<Eigen::Index>(soup.cells.size()), 4);
  options.matching_weights = VectorXd::Ones(static_cast<Eigen::Index>(soup.points.size()));
  options.matching_weights[13 + 39 + 5] = 1000; // on the axis of the bar
  const Point_matrix stiff = pose_of(options);
  options = single;
  options.registration.detail_length *= 2;
  EXPECT_LT((pose_of(options) - stiff).norm(), 1e-9);
  EXPECT_GT((plain - stiff).norm(), 1e-3);
  options.stiffness = VectorXd::Ones(3);
  EXPECT_THROW_WITH(pose_of(options), std::invalid_argument, "3 numbers are given as stiffness");
  options.stiffness.resize(0);
  options.matching_weights = VectorXd::Ones(3);
  EXPECT_THROW_WITH(pose_of(options), std::invalid_argument,
                    "3 numbers are given as matching weight");
}

TEST(Weights_of_surfaces, bad_factors_are_named)
{
  const shapes::Triangle_soup bars = shapes::two_bars();
  const Eigen::Index n = static_cast<Eigen::Index>(bars.points.size());
  CP::Options options = shapes::each_component();
  options.matching_weights = VectorXd::Ones(n - 1);
  EXPECT_THROW_WITH(shapes::pose_of(bars, options), std::invalid_argument,
                    std::to_string(n - 1) + " numbers are given as matching weight, but it takes "
                      + std::to_string(n) + ", one per vertex");
  for(const double value : {-1., std::nan("")})
  {
    options.matching_weights = options.stiffness = VectorXd::Ones(n);
    options.matching_weights[n - 2] = value;
    EXPECT_THROW_WITH(shapes::pose_of(bars, options), std::invalid_argument,
                      "the matching weight of vertex " + std::to_string(n - 2));
    options.matching_weights.resize(0);
    options.stiffness[n - 2] = value;
    EXPECT_THROW_WITH(shapes::pose_of(bars, options), std::invalid_argument,
                      "the stiffness of vertex " + std::to_string(n - 2));
  }
  options = shapes::each_component();
  options.matching_weights = VectorXd::Zero(n); // then in a single component
  EXPECT_THROW_WITH(shapes::pose_of(bars, options), std::invalid_argument,
                    "the matching weight of every vertex is 0");
  options.matching_weights.head(n / 2).setOnes();
  EXPECT_THROW_WITH(shapes::pose_of(bars, options), std::invalid_argument,
                    "all matching weights are 0 in the part around vertex");
}

TEST(Weights_of_surfaces, property_values_are_in_the_order_of_the_vertices)
{
  Mesh mesh = shapes::to_mesh<Mesh>(shapes::bent_bar());
  auto map = mesh.add_property_map<Mesh::Vertex_index, int>("v:factor", 3).first;
  mesh.remove_vertex(mesh.add_vertex()); // has no row
  map[Mesh::Vertex_index(7)] = 5;
  VectorXd expected = VectorXd::Constant(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
  expected[7] = 5;
  EXPECT_TRUE(CP::property_values(vertices(mesh), map) == expected);
}

} // namespace test_weights_of_the_call
