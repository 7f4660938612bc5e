// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_OTHER_CANONICAL_FORMS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_OTHER_CANONICAL_FORMS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>

#include "Cotangent_laplacian.h"
#include "Laplacian_spectrum.h"
#include "Sparse_system.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

// Canonical forms of other authors, as references. All are connected surfaces; forms have one row per
// vertex.

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;
using CGAL::Canonical_pose_3::Surface_component_3;

/// Global point signatures (Rustamov 2007) in three dimensions: the eigenfunctions of the Laplacian
/// with the smallest positive eigenvalues, each divided by the root of its eigenvalue. Neither signs
/// nor, for similar eigenvalues, the order are determined.
inline Point_matrix global_point_signature(const Surface_component_3& surface)
{
  const Laplacian_spectrum spectrum(surface.points, surface.triangles, 4);
  Point_matrix result(surface.points.rows(), 3);
  for(Eigen::Index k = 0; k < 3; ++k)
    result.col(k) = spectrum.functions.col(k + 1) / std::sqrt(spectrum.values[k + 1]);
  return result;
}

/// Fast classical scaling (Shamai, Zibulevsky, Kimmel 2018): squared distances between landmarks are
/// extended to all pairs of vertices, as M K M^t, by smooth functions M that minimize the biharmonic
/// energy plus `MU` times the squared errors at the landmarks; classical scaling of this matrix needs
/// eigenvectors of the size of K only. `fields`: of which only rows of landmarks are used.
inline Point_matrix fast_classical_scaling(const Surface_component_3& surface,
                                           const std::vector<std::size_t>& landmarks,
                                           const Eigen::MatrixXd& distances)
{
  constexpr double MU = 1e7; // for a surface of area 1; the result hardly depends on it
  const Cotangent_laplacian laplacian(surface.points, surface.triangles);
  const Eigen::VectorXd mass = laplacian.mass.cwiseMax(1e-3 * laplacian.mass.mean());
  const Eigen::Index n = mass.size(), l = distances.cols();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, l);
  for(Eigen::Index k = 0; k < l; ++k)
    right(static_cast<Eigen::Index>(landmarks[static_cast<std::size_t>(k)]), k) = MU;
  Eigen::SparseMatrix<double> matrix
    = laplacian.stiffness * mass.cwiseInverse().asDiagonal() * laplacian.stiffness;
  matrix += Eigen::SparseMatrix<double>(Eigen::VectorXd(right.rowwise().sum()).asDiagonal());
  Eigen::MatrixXd extension = Sparse_system(matrix).solve(right);
  extension.rowwise() -= extension.colwise().mean().eval();

  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(extension);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(l).triangularView<Eigen::Upper>();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
    -0.5 * r * (0.5 * (distances + distances.transpose())).cwiseAbs2() * r.transpose());
  const Eigen::MatrixXd coordinates
    = eigen.eigenvectors().rightCols<3>()
      * eigen.eigenvalues().tail<3>().cwiseMax(0).cwiseSqrt().asDiagonal();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, 3);
  result.topRows(l) = coordinates;
  return qr.householderQ() * result;
}

/// A form by Euclidean distances in linear time, after the idea of Pickup et al. (2015): distances
/// between a few vertices are made large, while the edges keep their lengths,
///   sum over edges (|e| - |e at rest|)^2 - mu sum over pairs of `features` |v_i - v_j|.
/// Only the abstract of that paper was available: this energy, its weight and its minimization are
/// ours. Both terms have a majorant with the same constant matrix, as in SMACOF.
inline Point_matrix euclidean_form(const Surface_component_3& surface,
                                   const std::vector<std::size_t>& features)
{
  constexpr int ITERATIONS = 100;
  const Cotangent_laplacian laplacian(surface.points, surface.triangles); // for the area
  const double mu = 0.02 * std::sqrt(laplacian.area)
                    / static_cast<double>((std::max)(features.size(), std::size_t(1)));
  std::set<std::pair<int, int>> edges;
  for(const auto& t : surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      edges.insert(std::minmax(static_cast<int>(t[k]), static_cast<int>(t[(k + 1) % 3])));
  std::vector<Eigen::Triplet<double>> entries;
  for(const auto& [i, j] : edges)
    for(const auto& [p, q, value] : {std::tuple(i, i, 1.), {j, j, 1.}, {i, j, -1.}, {j, i, -1.}})
      entries.emplace_back(p, q, value);
  entries.emplace_back(0, 0, 1e-3); // holds the position of a vertex
  Eigen::SparseMatrix<double> matrix(surface.points.rows(), surface.points.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Sparse_system system(matrix);

  Point_matrix points = surface.points;
  for(int iteration = 0; iteration < ITERATIONS; ++iteration)
  {
    Point_matrix right = Point_matrix::Zero(points.rows(), 3);
    right.row(0) = 1e-3 * surface.points.row(0);
    const auto push = [&](const Eigen::Index i, const Eigen::Index j, const double length) {
      const Eigen::RowVector3d force = length * (points.row(i) - points.row(j)).stableNormalized();
      right.row(i) += force;
      right.row(j) -= force;
    };
    for(const auto& [i, j] : edges)
      push(i, j, (surface.points.row(i) - surface.points.row(j)).norm());
    for(std::size_t i = 0; i < features.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        push(static_cast<Eigen::Index>(features[i]), static_cast<Eigen::Index>(features[j]),
             mu / 2);
    points = system.solve(right);
  }
  return points;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_OTHER_CANONICAL_FORMS_H
