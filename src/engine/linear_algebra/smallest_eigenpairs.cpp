// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "smallest_eigenpairs.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The factors of a tridiagonal symmetric matrix minus a multiple of the identity, by elimination with
// row exchanges. Pivots of 0 are replaced by tiny ones, for inverse iteration.
class Shifted_tridiagonal_factor
{
public:
  Shifted_tridiagonal_factor(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& subdiagonal,
                             const double shift, const double tiny)
    : m_pivots(diagonal.array() - shift), m_first(subdiagonal),
      m_second(Eigen::VectorXd::Zero(diagonal.size())), m_factors(subdiagonal.size()),
      m_is_exchanged(static_cast<std::size_t>(subdiagonal.size()), false)
  {
    const Eigen::Index n = m_pivots.size();
    for(Eigen::Index i = 0; i + 1 < n; ++i)
    {
      const double below = subdiagonal[i];
      if(std::abs(below) > std::abs(m_pivots[i]))
      {
        m_is_exchanged[static_cast<std::size_t>(i)] = true;
        m_factors[i] = m_pivots[i] / below;
        const double next = m_pivots[i + 1], above = m_first[i];
        m_pivots[i] = below;
        m_first[i] = next;
        m_pivots[i + 1] = above - m_factors[i] * next;
        if(i + 2 < n)
        {
          m_second[i] = m_first[i + 1];
          m_first[i + 1] *= -m_factors[i];
        }
      }
      else
      {
        replace_if_zero(m_pivots[i], tiny);
        m_factors[i] = below / m_pivots[i];
        m_pivots[i + 1] -= m_factors[i] * m_first[i];
      }
    }
    replace_if_zero(m_pivots[n - 1], tiny);
  }

  void solve(Eigen::Ref<Eigen::VectorXd> x) const
  {
    const Eigen::Index n = m_pivots.size();
    for(Eigen::Index i = 0; i + 1 < n; ++i)
    {
      if(m_is_exchanged[static_cast<std::size_t>(i)])
        std::swap(x[i], x[i + 1]);
      x[i + 1] -= m_factors[i] * x[i];
    }
    for(Eigen::Index i = n; i-- > 0;)
    {
      if(i + 1 < n)
        x[i] -= m_first[i] * x[i + 1];
      if(i + 2 < n)
        x[i] -= m_second[i] * x[i + 2];
      x[i] /= m_pivots[i];
    }
  }

private:
  static void replace_if_zero(double& pivot, const double tiny)
  {
    if(std::abs(pivot) < tiny)
      pivot = pivot < 0 ? -tiny : tiny;
  }

  Eigen::VectorXd m_pivots, m_first, m_second, m_factors;
  std::vector<bool> m_is_exchanged;
};

// Eigenvectors of a tridiagonal symmetric matrix, for the first of `eigenvalues`, by inverse iteration;
// orthonormal. Nothing if they are not exact enough.
inline std::optional<Eigen::MatrixXd> tridiagonal_eigenvectors(const Eigen::VectorXd& diagonal,
                                                               const Eigen::VectorXd& subdiagonal,
                                                               const Eigen::VectorXd& eigenvalues,
                                                               const Eigen::Index count)
{
  constexpr int number_of_iterations = 3;
  constexpr double largest_residual = 1e-10; // by the norm of the matrix
  const Eigen::Index n = diagonal.size();
  const double norm
    = (std::max)(eigenvalues.cwiseAbs().maxCoeff(), (std::numeric_limits<double>::min)());
  std::mt19937 engine(1);
  Eigen::MatrixXd result(n, count);
  for(Eigen::Index k = 0; k < count; ++k)
  {
    const Shifted_tridiagonal_factor factor(diagonal, subdiagonal, eigenvalues[k],
                                            std::numeric_limits<double>::epsilon() * norm);
    auto v = result.col(k);
    for(double& x : v)
      x = static_cast<double>(engine()) / 4294967296. - .5;
    const auto others = result.leftCols(k);
    for(int i = 0; i < number_of_iterations; ++i)
    {
      factor.solve(v);
      v.stableNormalize();
      for(int pass = 0; pass < 2; ++pass)
      {
        v -= others * (others.transpose() * v).eval();
        v.normalize();
      }
    }
    Eigen::VectorXd residual = (diagonal.array() - eigenvalues[k]).matrix().cwiseProduct(v);
    residual.head(n - 1) += subdiagonal.cwiseProduct(v.tail(n - 1));
    residual.tail(n - 1) += subdiagonal.cwiseProduct(v.head(n - 1));
    if(!(residual.norm() <= largest_residual * norm))
      return std::nullopt;
  }
  return result;
}

std::optional<Eigenpairs> smallest_eigenpairs(const Eigen::MatrixXd& matrix, const Eigen::Index count)
{
  const Eigen::Index n = matrix.rows(), number = (std::min)(count, n);
  if(2 * number < n)
  {
    const Eigen::Tridiagonalization<Eigen::MatrixXd> tridiagonal(matrix);
    const Eigen::VectorXd diagonal = tridiagonal.diagonal();
    const Eigen::VectorXd subdiagonal = tridiagonal.subDiagonal();
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, subdiagonal, Eigen::EigenvaluesOnly);
    if(solver.info() == Eigen::Success)
      if(const auto vectors
         = tridiagonal_eigenvectors(diagonal, subdiagonal, solver.eigenvalues(), number))
        return Eigenpairs{solver.eigenvalues().head(number), tridiagonal.matrixQ() * *vectors};
  }
  std::optional<Eigenpairs> all = all_eigenpairs(matrix);
  if(!all)
    return std::nullopt;
  return Eigenpairs{all->values.head(number), all->vectors.leftCols(number)};
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
