// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "conforming_bar.h"
#include "matchers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace test_stiffness {

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;
using Eigen::VectorXd;

// by the center of the cell
bool is_in_left_half(const CP::Conforming_body_3& body, const std::array<int, 4>& cell)
{
  double x = 0;
  for(const int v : cell)
    x += body.points()(v, 0) / 4;
  return x < body.points().col(0).mean();
}

double largest_edge_strain(const CP::Conforming_body_3& body, const Point_matrix& pose,
                           const std::array<int, 4>& cell)
{
  double result = 0;
  for(const int p : cell)
    for(const int q : cell)
      if(p < q)
        result
          = (std::max)(result, std::abs((pose.row(p) - pose.row(q)).norm()
                                          / (body.points().row(p) - body.points().row(q)).norm()
                                        - 1));
  return result;
}

// Stiffness multiplies the elastic term like the squared detail length. A stiffness of 1 changes no
// digit.
TEST(Stiffness, everywhere_is_detail_length)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const Point_matrix target = conforming_bar(2.).points();
  const VectorXd weights = uniform_weights(target);
  CP::Registration_options options;
  const Bar_result plain = register_bar(body, target, weights, options);
  const Bar_result ones = register_bar(body, target, weights, options, cells_with(body, 1));
  EXPECT_EQ(ones.pose, plain.pose);
  EXPECT_EQ(ones.summary.energy_history, plain.summary.energy_history);
  for(const double c : {0.3, 7.})
  {
    options = CP::Registration_options();
    options.number_of_iterations = 30;
    const Bar_result stiff = register_bar(body, target, weights, options, cells_with(body, c));
    options.detail_length *= std::sqrt(c);
    const Bar_result expected = register_bar(body, target, weights, options);
    EXPECT_LT((stiff.pose - expected.pose).norm(), 1e-10);
    EXPECT_NEAR(stiff.summary.energy_arap, expected.summary.energy_arap, 1e-12);
    EXPECT_NEAR(stiff.summary.volume_ratio, expected.summary.volume_ratio, 1e-12);
    EXPECT_GT((stiff.pose - plain.pose).norm(), 1e-3);
  }
}

// The energy at rest is the matching energy E0, and bounds the energy of the result. So |F_t -
// R_t|^2 <= E0 / (l^2 S w_t) in cells of stiffness S, which bounds the squared relative change of
// any length in the cell.
TEST(Stiffness, stiff_half_stays_rigid)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const Point_matrix target = conforming_bar(3.).points();
  const VectorXd weights = uniform_weights(target);
  const double stiffness = 1e8;
  VectorXd factors = cells_with(body, 1);
  for(std::size_t t = 0; t < body.cells().size(); ++t)
    if(is_in_left_half(body, body.cells()[t]))
      factors[static_cast<Eigen::Index>(t)] = stiffness;
  const Bar_result result = register_bar(body, target, weights, {}, factors);
  EXPECT_TRUE(Canonical_pose_test::never_rises(result.summary.energy_history));
  const double energy_at_rest = (body.points() - target).rowwise().squaredNorm().dot(weights) / 64;
  EXPECT_NEAR(result.summary.energy_history.front(), energy_at_rest, 1e-12);
  double largest_of_soft = 0, largest_bound = 0;
  for(std::size_t t = 0; t < body.cells().size(); ++t)
  {
    const double strain = largest_edge_strain(body, result.pose, body.cells()[t]);
    if(!is_in_left_half(body, body.cells()[t]))
    {
      largest_of_soft = (std::max)(largest_of_soft, strain);
      continue;
    }
    const double bound = std::sqrt(
      energy_at_rest / (0.1 * 0.1 * stiffness * body.cell_weights()[static_cast<Eigen::Index>(t)]));
    EXPECT_LE(strain, bound);
    largest_bound = (std::max)(largest_bound, bound);
  }
  EXPECT_LT(largest_bound, 0.02);
  EXPECT_GT(largest_of_soft, 5 * largest_bound);
}

// The volume is not weighted by stiffness: for a target of half the length everywhere, and cells so
// soft that they follow, it is half of that at rest, regardless of the factors.
TEST(Stiffness, volume_does_not_know_it)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const Point_matrix target = body.points() * Eigen::Vector3d(0.5, 1, 1).asDiagonal();
  VectorXd factors = 1e-9 * VectorXd::LinSpaced(cells_with(body, 1).size(), 1, 100);
  const Bar_result result = register_bar(body, target, uniform_weights(target), {}, factors);
  EXPECT_NEAR(result.summary.volume_ratio, 0.5, 1e-6);
}

} // namespace test_stiffness
