// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// With the weights, kernel and fairing of the paper, the package implements the paper as printed:
// it is compared after each iteration with paper_equations.h, a dense reference that shares no code
// with it. Both differ only by rounding, about 1e-14 here.

#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "paper_equations.h"
#include "registrar.h"
#include "shapes.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_literal_mode {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Paper_equations;
using Canonical_pose_test::Spring;
using Canonical_pose_test::Tetrahedral_soup;
using Canonical_pose_test::to_body;
using Canonical_pose_test::to_matrix;
using CP::Point_matrix;

using Spring = std::optional<CP::Spring_3>;

// Bent, squeezed to a fifth of its width and creased, with one corner pulled in: some cells are
// inverted.
Point_matrix bent_target(const Tetrahedral_soup& body)
{
  Point_matrix target = to_matrix(Canonical_pose_test::transformed(
    body.points, [](const auto& p) { return Canonical_pose_test::bend(p, 2., 2.5); }));
  target.col(1) = 0.2 * target.col(1) - 0.3 * target.col(2).cwiseAbs2();
  target.row(0) = target.row(target.rows() / 2);
  return target;
}

void compare(const Tetrahedral_soup& box, const Spring& spring)
{
  const CP::Conforming_body_3 body = to_body(box);
  const std::size_t n = box.points.size();
  const Point_matrix target = bent_target(box);
  Paper_equations paper(box, target, spring);
  CP::Spring_constraint_adaptor_3 springs(n);
  if(spring)
    springs.insert({spring->p, spring->q, spring->rest_length, spring->stiffness / double(n)});

  const double length_scale = 2.7; // arbitrary: it cancels
  CP::Registration_options options;
  options.set_paper_weights(Canonical_pose_test::PAPER_ALPHA, Canonical_pose_test::PAPER_BETA, n,
                            body.volume(), length_scale);
  options.fairing_passes = 1;
  options.energy_tolerance = options.move_tolerance = 0;
  Canonical_pose_test::Svd_registrar registrar(
    body, Canonical_pose_test::uniform_weights(body.points()), length_scale, options);
  registrar.set_target(target);
  registrar.add_constraint(springs);
  registrar.set_number_of_iterations(0);
  Point_matrix start;
  EXPECT_GT(registrar.register_to_target(start).inverted, 0u);
  for(int k = 1; k <= 15; ++k)
  {
    registrar.set_number_of_iterations(k);
    Point_matrix pose;
    ASSERT_EQ(registrar.register_to_target(pose).iterations, k);
    EXPECT_LT((pose - paper.iterate()).cwiseAbs().maxCoeff(), 1e-10) << "after iteration " << k;
  }
}

// 2 of its 36 vertices are interior.
const Tetrahedral_soup BOX = Canonical_pose_test::tetrahedral_box(3, 2, 2, {{2., 0.8, 0.5}});

TEST(Literal_mode, equation_13) { compare(BOX, {}); }

TEST(Literal_mode, equation_16) { compare(BOX, CP::Spring_3{0, 35, 0.4, 50.}); }

// The one call in literal mode, with rotations in closed form.
TEST(Literal_mode, one_call)
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  // All of its vertices are on the boundary.
  const Tetrahedral_soup box = Canonical_pose_test::tetrahedral_box(4, 2, 1, {{2., 0.8, 0.3}});
  CP::Indexed_tetrahedra_3<Point_3> complex;
  for(const auto& p : box.points)
    complex.points.emplace_back(p[0], p[1], p[2]);
  complex.cells = box.cells;
  CP::Options options;
  options.given.target = bent_target(box);
  options.paper_weights = CP::Paper_weights();
  options.registration.number_of_iterations = 10;
  options.registration.energy_tolerance = options.registration.move_tolerance = 0;
  std::vector<Point_3> pose(box.points.size());
  CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), options);

  Paper_equations paper(box, *options.given.target, {});
  Point_matrix expected;
  for(int k = 0; k < 10; ++k)
    expected = paper.iterate();
  EXPECT_LT((to_matrix(pose) - expected).cwiseAbs().maxCoeff(), 1e-6);
}

// Equation 3 with the affinity of Section 5, not centered. The paper does not specify the unit of
// the coordinates, and signs of eigenvectors are arbitrary.
TEST(Literal_mode, equation_3)
{
  const int n = 60, l = 20;
  Eigen::MatrixXd cloud(n, 4);
  for(int i = 0; i < n; ++i)
    cloud.row(i) << 3 * std::sin(7. * i), 2 * std::cos(5. * i), std::sin(3. * i * i),
      std::cos(11. * i);
  CP::Landmark_fields_3 fields;
  fields.distances.resize(n, l);
  for(int j = 0; j < l; ++j)
  {
    fields.landmarks.push_back(3 * j);
    fields.distances.col(j) = (cloud.rowwise() - cloud.row(3 * j)).rowwise().norm();
  }
  CP::Landmark_mds_target_builder_3<CP::Gaussian_kernel> builder{CP::Gaussian_kernel(false)};
  builder.build(fields);
  const double sigma = fields.distances.maxCoeff() / 2;
  const Eigen::MatrixXd g = (-fields.distances.array().square() / (2 * sigma * sigma)).exp();
  Eigen::MatrixXd affinity(l, l);
  for(int i = 0; i < l; ++i)
    affinity.row(i) = g.row(3 * i);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(affinity);
  const Eigen::VectorXd g_mean = affinity.rowwise().mean();
  double scale = 0;
  for(int c = 0; c < 3; ++c)
  {
    const Eigen::Index k = l - 1 - c; // they are in increasing order
    const Eigen::VectorXd q = eigen.eigenvectors().col(k) / std::sqrt(eigen.eigenvalues()[k]);
    const Eigen::VectorXd expected = (g.rowwise() - g_mean.transpose()) * q;
    const Eigen::VectorXd found = builder.targets().col(c);
    const double ratio = found.dot(expected) / expected.squaredNorm();
    scale = c == 0 ? std::abs(ratio) : scale;
    EXPECT_NEAR(std::abs(ratio), scale, 1e-10 * scale);
    EXPECT_LT((found - ratio * expected).norm(), 1e-10 * found.norm());
  }
}

} // namespace test_literal_mode
