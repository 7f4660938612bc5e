// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/cell_stiffness.h>

#include <gtest/gtest.h>

#include "conforming_bar.h"
#include "matchers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace test_cell_stiffness {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::conforming_bar;
using CP::Point_matrix;
using Eigen::VectorXd;

// If surface and body have the same vertices, the value of a cell is the mean of its corners; a
// constant remains constant.
TEST(Cell_stiffness, is_the_mean_of_the_corners)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const VectorXd shares = VectorXd::LinSpaced(body.points().rows(), 1, 2);
  const VectorXd values = VectorXd::LinSpaced(body.points().rows(), 1, 9).array().square();
  const VectorXd result = CP::cell_stiffness(body, shares, values);
  for(std::size_t t = 0; t < body.cells().size(); ++t)
  {
    double mean = 0;
    for(const int v : body.cells()[t])
      mean += values[v] / 4;
    EXPECT_NEAR(result[static_cast<Eigen::Index>(t)], mean, 1e-12 * mean);
  }
  EXPECT_EQ(CP::cell_stiffness(body, shares, VectorXd::Ones(shares.size())),
            VectorXd::Ones(result.size()));
}

// Only one edge of the bar is surface: values propagate inward from there, stay between the
// extremes, and do not depend on the order of cells and body vertices. An adjacent second bar has
// its own values.
TEST(Cell_stiffness, runs_inwards)
{
  const CP::Conforming_body_3 bar = conforming_bar(0.);
  const Eigen::Index n = bar.points().rows(), edge = 13;
  const int step = 7; // coprime to 2n - 2 * edge: permutes the interior body vertices
  std::vector<int> rows(static_cast<std::size_t>(2 * n)), relabeled(rows.size());
  for(Eigen::Index v = 0; v < n; ++v) // the two edges first
    for(int copy = 0; copy < 2; ++copy)
      rows[static_cast<std::size_t>(v + copy * n)]
        = static_cast<int>(v < edge ? v + copy * edge : 2 * edge + (v - edge) + copy * (n - edge));
  const int inner = static_cast<int>(2 * (n - edge)), surface = static_cast<int>(2 * edge);
  for(std::size_t v = 0; v < rows.size(); ++v)
    relabeled[v] = rows[v] < surface ? rows[v] : surface + (rows[v] - surface) * step % inner;
  ASSERT_EQ(std::gcd(step, inner), 1);

  const auto body = [&](const std::vector<int>& rows_of_copies, const bool is_reversed) {
    Point_matrix points(2 * n, 3);
    std::vector<std::array<int, 4>> cells;
    for(int copy = 0; copy < 2; ++copy)
    {
      for(Eigen::Index v = 0; v < n; ++v)
        points.row(rows_of_copies[static_cast<std::size_t>(v + copy * n)])
          = bar.points().row(v) + copy * Eigen::RowVector3d(0, 0, 1e-6);
      for(const auto& c : bar.cells())
      {
        cells.emplace_back();
        for(std::size_t k = 0; k < 4; ++k)
          cells.back()[k] = rows_of_copies[static_cast<std::size_t>(c[k] + copy * n)];
      }
    }
    if(is_reversed)
      std::reverse(cells.begin(), cells.end());
    return CP::Conforming_body_3(points, cells, static_cast<std::size_t>(surface));
  };
  VectorXd values(surface);
  values << VectorXd::LinSpaced(edge, 1, 2), VectorXd::LinSpaced(edge, 10, 20);
  const VectorXd shares = VectorXd::Ones(surface);
  const VectorXd result = CP::cell_stiffness(body(rows, false), shares, values);
  const Eigen::Index half = result.size() / 2;
  EXPECT_GE(result.head(half).minCoeff(), 1);
  EXPECT_LE(result.head(half).maxCoeff(), 2);
  EXPECT_GE(result.tail(half).minCoeff(), 10);
  EXPECT_LE(result.tail(half).maxCoeff(), 20);
  EXPECT_LT(result[0], result[half - 1]); // increases along the bar, like the given values
  const VectorXd other = CP::cell_stiffness(body(relabeled, true), shares, values);
  EXPECT_LT((other.reverse() - result).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Cell_stiffness, bad_numbers_are_named)
{
  const CP::Conforming_body_3 body = conforming_bar(0.);
  const VectorXd shares = VectorXd::Ones(body.points().rows());
  EXPECT_THROW_WITH(CP::cell_stiffness(body, shares, VectorXd::Ones(3)), std::invalid_argument,
                    "3 numbers are given as stiffness");
  VectorXd values = shares;
  values[5] = 0;
  EXPECT_THROW_WITH(CP::cell_stiffness(body, shares, values), std::invalid_argument,
                    "the stiffness of vertex 5 is ");
  EXPECT_THROW(CP::cell_stiffness(body, VectorXd::Ones(3), shares), CGAL::Precondition_exception);
}

} // namespace test_cell_stiffness
