// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/linear_algebra/smallest_eigenpairs.h"

#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>

namespace test_leading_eigenvectors {

namespace CP = CGAL::Canonical_pose_3;

Eigen::MatrixXd random_matrix(const Eigen::Index rows, const Eigen::Index columns)
{
  CGAL::Random random(7);
  Eigen::MatrixXd result(rows, columns);
  for(Eigen::Index j = 0; j < columns; ++j)
    for(Eigen::Index i = 0; i < rows; ++i)
      result(i, j) = random.get_double(-1., 1.);
  return result;
}

// A symmetric matrix with given eigenvalues.
Eigen::MatrixXd matrix_of(const Eigen::VectorXd& eigenvalues)
{
  const Eigen::Index n = eigenvalues.size();
  const Eigen::MatrixXd q
    = Eigen::HouseholderQR<Eigen::MatrixXd>(random_matrix(n, n)).householderQ();
  const Eigen::MatrixXd result = q * eigenvalues.asDiagonal() * q.transpose();
  return (result + result.transpose()) / 2;
}

// The eigenvalues are those of the full decomposition, and the vectors are orthonormal eigenvectors.
void expect_leading(const Eigen::MatrixXd& matrix, const Eigen::Index count)
{
  const CP::internal::Eigenpairs pairs = CP::internal::leading_eigenpairs(matrix, count);
  const double size = matrix.norm();
  const Eigen::VectorXd expected
    = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  ASSERT_EQ(pairs.values.size(), count);
  EXPECT_LE((pairs.values - expected.tail(count).reverse()).cwiseAbs().maxCoeff(), 1e-13 * size);
  EXPECT_LE((matrix * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).norm(),
            1e-12 * size);
  EXPECT_LE(
    (pairs.vectors.transpose() * pairs.vectors - Eigen::MatrixXd::Identity(count, count)).norm(),
    1e-12);
}

// The same for the smallest ones.
void expect_smallest(const Eigen::MatrixXd& matrix, const Eigen::Index count)
{
  const std::optional<CP::internal::Eigenpairs> pairs
    = CP::internal::smallest_eigenpairs(matrix, count);
  ASSERT_TRUE(pairs);
  const double size = matrix.norm();
  const Eigen::VectorXd expected
    = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  ASSERT_EQ(pairs->values.size(), count);
  EXPECT_LE((pairs->values - expected.head(count)).cwiseAbs().maxCoeff(), 1e-13 * size);
  EXPECT_LE((matrix * pairs->vectors - pairs->vectors * pairs->values.asDiagonal()).norm(),
            1e-12 * size);
  EXPECT_LE(
    (pairs->vectors.transpose() * pairs->vectors - Eigen::MatrixXd::Identity(count, count)).norm(),
    1e-12);
}

// The two methods only differ by rounding. The largest eigenvalues of random matrices are close to
// each other; 9 and 17 rows are one more than one and two blocks; 2 and 5 are less than a block.
TEST(Leading_eigenvectors, of_random_matrices)
{
  for(const Eigen::Index n : {2, 5, 8, 9, 16, 17, 40, 350})
  {
    const Eigen::MatrixXd m = random_matrix(n, n);
    expect_leading(m + m.transpose(), (std::min)(n, Eigen::Index(6)));
  }
  expect_leading(random_matrix(400, 12) * random_matrix(400, 12).transpose(), 11);
}

// A block of eight finds an eigenvalue of multiplicity up to eight; higher ones are not requested.
TEST(Leading_eigenvectors, multiple)
{
  for(const Eigen::Index copies : {2, 3, 5, 8, 40})
  {
    Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(320, 0, 1);
    values.tail(copies).setConstant(2);
    expect_leading(matrix_of(values), 6);
  }
  expect_leading(Eigen::MatrixXd::Identity(320, 320), 6);
}

// The largest eigenvalues are requested, not those of largest modulus.
TEST(Leading_eigenvectors, beside_large_negative_ones)
{
  Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(320, -1, 1);
  values.head(30).setConstant(-100);
  expect_leading(matrix_of(values), 6);
  expect_leading(-Eigen::MatrixXd::Identity(320, 320), 6);
  expect_leading(matrix_of(Eigen::VectorXd::LinSpaced(320, -5, -1)), 6);
}

// The space spanned by a block is then exhausted after one or two steps; the other eigenvalues are
// 0.
TEST(Leading_eigenvectors, of_low_rank)
{
  expect_leading(Eigen::MatrixXd::Zero(320, 320), 6);
  for(const Eigen::Index rank : {1, 2, 3})
  {
    const Eigen::MatrixXd m = random_matrix(320, rank);
    expect_leading(m * m.transpose(), 6);
    expect_leading(m * m.transpose() * std::ldexp(1., 300), 6);
  }
}

// Inverse iteration and the full decomposition only differ by rounding, also if eigenvalues are
// multiple, or if the matrix splits into blocks (the path of 300 vertices, twice, without an edge
// between them).
TEST(Smallest_eigenpairs, of_matrices_of_all_kinds)
{
  for(const Eigen::Index n : {1, 2, 5, 17, 121, 300})
  {
    const Eigen::MatrixXd m = random_matrix(n, n);
    expect_smallest(m + m.transpose(), (std::min)(n, Eigen::Index(60)));
  }
  Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(300, 0, 1);
  for(const Eigen::Index copies : {2, 40, 200})
  {
    values.head(copies).setConstant(-1);
    expect_smallest(matrix_of(values), 60);
    expect_smallest(matrix_of(values) * std::ldexp(1., 300), 60);
  }
  expect_smallest(Eigen::MatrixXd::Identity(300, 300), 60);
  expect_smallest(Eigen::MatrixXd::Zero(300, 300), 60);
  Eigen::MatrixXd paths = Eigen::MatrixXd::Zero(600, 600);
  for(Eigen::Index i = 0; i + 1 < 600; ++i)
    if(i != 299)
    {
      paths(i, i) += 1;
      paths(i + 1, i + 1) += 1;
      paths(i, i + 1) -= 1;
      paths(i + 1, i) -= 1;
    }
  expect_smallest(paths, 60);
}

// Classical scaling is exact on Euclidean distances (see test_landmark_mds): also with more
// landmarks than are fully decomposed. Points in the plane remain flat, and a regular octahedron
// has three equal eigenvalues.
TEST(Leading_eigenvectors, landmark_mds)
{
  Eigen::MatrixXd octahedra = Eigen::MatrixXd::Zero(402, 3);
  for(Eigen::Index i = 0; i < octahedra.rows(); ++i)
    octahedra(i, i % 3) = i % 2 == 0 ? 1 : -1;
  Eigen::MatrixXd flat = random_matrix(420, 3);
  flat.col(2).setZero();
  for(const Eigen::MatrixXd& points : {random_matrix(450, 3), flat, octahedra})
  {
    const Eigen::Index n = points.rows();
    CP::Landmark_fields_3 fields;
    fields.distances.resize(n, 400);
    for(Eigen::Index j = 0; j < 400; ++j)
    {
      fields.landmarks.push_back(std::size_t(j));
      fields.distances.col(j) = (points.rowwise() - points.row(j)).rowwise().norm();
    }
    CP::Landmark_mds_target_builder_3<> builder;
    builder.build(fields);
    const bool is_flat = points.col(2).isZero();
    EXPECT_EQ(builder.number_of_positive_eigenvalues(), is_flat ? 2 : 3);
    EXPECT_EQ(builder.targets().col(2).isZero(0), is_flat);
    EXPECT_GE(builder.eigenvalues().size(), 6);
    double error = 0;
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < i; ++j)
        error
          = (std::max)(error, std::abs((builder.targets().row(i) - builder.targets().row(j)).norm()
                                       - (points.row(i) - points.row(j)).norm()));
    EXPECT_LE(error, 1e-9);
  }
}

} // namespace test_leading_eigenvectors
