// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_LAPLACIAN_SPECTRUM_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_LAPLACIAN_SPECTRUM_H

#include "Cotangent_laplacian.h"
#include "Sparse_system.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Canonical_pose_benchmark {

/// The smallest eigenvalues of the Laplacian of a connected surface of area 1, with their
/// eigenfunctions, a column each, which are orthonormal with respect to the mass. The first is 0.
struct Laplacian_spectrum
{
  Laplacian_spectrum(const CGAL::Canonical_pose_3::Point_matrix& points,
                     const std::vector<std::array<std::size_t, 3>>& triangles,
                     const Eigen::Index number)
  {
    const Cotangent_laplacian laplacian(points, triangles);
    const double shift = 0.1; // the smallest positive eigenvalue of a surface of area 1 is 1 to 30

    // The inverse of the shifted Laplacian, symmetric by the roots of the mass.
    struct Inverse
    {
      using Scalar = double;
      Eigen::VectorXd roots;
      Sparse_system system;
      Eigen::Index rows() const { return roots.size(); }
      Eigen::Index cols() const { return roots.size(); }
      void perform_op(const double* in, double* out) const
      {
        const Eigen::Map<const Eigen::VectorXd> x(in, roots.size());
        Eigen::Map<Eigen::VectorXd>(out, roots.size())
          = roots.cwiseProduct(system.solve(roots.cwiseProduct(x)).col(0));
      }
    };
    // Vertices whose triangles all have area 0 follow their neighbors.
    mass = laplacian.mass.cwiseMax(1e-3 * laplacian.mass.mean());
    Eigen::SparseMatrix<double> matrix = laplacian.stiffness;
    matrix += Eigen::SparseMatrix<double>((shift * mass).asDiagonal());
    Inverse inverse{mass.cwiseSqrt(), Sparse_system(matrix)};
    Spectra::SymEigsSolver<Inverse> solver(
      inverse, number, (std::min)(mass.size(), (std::max)(Eigen::Index(20), 2 * number)));
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge);
    if(solver.info() != Spectra::CompInfo::Successful)
      throw std::runtime_error("the eigensolver has not converged");
    values = solver.eigenvalues().cwiseInverse().array() - shift;
    functions = inverse.roots.cwiseInverse().asDiagonal() * solver.eigenvectors();
  }

  Eigen::VectorXd mass, values;
  Eigen::MatrixXd functions;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_LAPLACIAN_SPECTRUM_H
