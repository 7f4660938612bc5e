// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_LAPLACE_SPECTRUM_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_LAPLACE_SPECTRUM_H

#include "Sparse_factor.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#ifdef CGAL_CANONICAL_POSE_3_USE_SPECTRA
#include <Spectra/SymEigsSolver.h>
#endif

#include <algorithm>
#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The smallest positive eigenvalues of L phi = lambda M phi on a connected surface, where L is the
// cotangent Laplacian and M the diagonal lumped mass matrix, with M-orthonormal eigenfunctions.
class Laplace_spectrum
{
public:
  // At most `count` eigenvalues, of n - 1. Throws `std::runtime_error` if they are not found.
  Laplace_spectrum(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                   Eigen::Index count, const Factor_maker factor_maker)
    : m_factor_maker(factor_maker), m_roots(mass.cwiseSqrt())
  {
    count = (std::min)(count, mass.size() - 1);
    if(mass.size() <= (std::max)(LARGEST_DENSE_SIZE, 4 * count))
      solve_densely(laplacian, count);
    else
      solve_iteratively(laplacian, mass, count);
    m_eigenfunctions = m_roots.cwiseInverse().asDiagonal() * m_eigenfunctions;
  }

  const Eigen::VectorXd& eigenvalues() const { return m_eigenvalues; }       // ascending
  const Eigen::MatrixXd& eigenfunctions() const { return m_eigenfunctions; } // a column each

private:
  static constexpr Eigen::Index LARGEST_DENSE_SIZE = 300;

  // x -> R (L + shift M)^-1 R x without its constant part, where R is the square root of the mass:
  // symmetric, with the eigenvalues 1 / (lambda + shift).
  class Shifted_inverse
  {
  public:
    using Scalar = double;

    Shifted_inverse(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                    const Eigen::VectorXd& roots, const double shift,
                    const Factor_maker factor_maker)
      : m_roots(roots), m_constant(roots.normalized()), m_factor(factor_maker)
    {
      Eigen::SparseMatrix<double> matrix = laplacian;
      matrix.diagonal() += shift * mass;
      m_factor.factor(matrix, "the shifted Laplacian");
    }

    Eigen::Index rows() const { return m_roots.size(); }
    Eigen::Index cols() const { return m_roots.size(); }

    void perform_op(const double* in, double* out) const
    {
      const Eigen::Map<const Eigen::VectorXd> x(in, rows());
      Eigen::Map<Eigen::VectorXd> y(out, rows());
      y = m_roots.cwiseProduct(m_factor.solve(m_roots.cwiseProduct(x)).col(0));
      y -= m_constant.dot(y) * m_constant;
    }

  private:
    const Eigen::VectorXd& m_roots;
    Eigen::VectorXd m_constant;
    Sparse_factor m_factor;
  };

  void solve_densely(const Eigen::SparseMatrix<double>& laplacian, const Eigen::Index count)
  {
    const Eigen::VectorXd inverse_roots = m_roots.cwiseInverse();
    const Eigen::MatrixXd matrix
      = inverse_roots.asDiagonal() * Eigen::MatrixXd(laplacian) * inverse_roots.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    if(solver.info() != Eigen::Success)
      throw std::runtime_error("the eigenvalues of the Laplacian are not found");
    m_eigenvalues = solver.eigenvalues().segment(1, count);
    m_eigenfunctions = solver.eigenvectors().middleCols(1, count);
  }

  void solve_iteratively(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                         const Eigen::Index count)
  {
    const double shift = 1 / mass.sum(); // similar to the smallest eigenvalue
    Shifted_inverse operation(laplacian, mass, m_roots, shift, m_factor_maker);
#ifdef CGAL_CANONICAL_POSE_3_USE_SPECTRA
    Spectra::SymEigsSolver<Shifted_inverse> solver(operation, count, 2 * count + 20);
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge, 1000, 1e-10, Spectra::SortRule::LargestAlge);
    if(solver.info() != Spectra::CompInfo::Successful)
      throw std::runtime_error("the eigenvalues of the Laplacian are not found");
    m_eigenvalues = solver.eigenvalues().cwiseInverse().array() - shift;
    m_eigenfunctions = solver.eigenvectors();
#else
    throw std::runtime_error("the library was built without Spectra, which computes eigenvalues");
#endif
  }

  Factor_maker m_factor_maker;
  Eigen::VectorXd m_roots, m_eigenvalues;
  Eigen::MatrixXd m_eigenfunctions;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_LAPLACE_SPECTRUM_H
