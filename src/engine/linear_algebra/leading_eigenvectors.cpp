// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/linear_algebra/dense_products.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <optional>
#include <random>
#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

std::optional<Eigenpairs> all_eigenpairs(const Eigen::MatrixXd& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  if(solver.info() != Eigen::Success)
    return std::nullopt;
  return Eigenpairs{solver.eigenvalues(), solver.eigenvectors()};
}

Eigenpairs largest_of_all_eigenpairs(const Eigen::MatrixXd& matrix, const Eigen::Index count)
{
  const std::optional<Eigenpairs> all = all_eigenpairs(matrix);
  if(!all)
    throw std::runtime_error("the eigenvalues of a symmetric matrix could not be computed");
  return {all->values.tail(count).reverse(), all->vectors.rightCols(count).rowwise().reverse()};
}

// An orthonormal basis of what `block` adds to a given orthonormal basis; columns that add less
// than `negligible` are removed. The second pass corrects errors of the first one due to
// cancellation.
inline Eigen::MatrixXd new_directions(Eigen::MatrixXd block,
                                      const Eigen::Ref<const Eigen::MatrixXd>& basis,
                                      const double negligible)
{
  for(const double smallest : {negligible, 0.5})
  {
    block -= product(basis, product_of_transposed(basis, block));
    Eigen::Index kept = 0;
    for(Eigen::Index j = 0; j < block.cols(); ++j)
    {
      Eigen::VectorXd v = block.col(j);
      for(int pass = 0; pass < 2; ++pass)
        v -= block.leftCols(kept) * (block.leftCols(kept).transpose() * v);
      if(v.norm() > smallest)
        block.col(kept++) = v.normalized();
    }
    block.conservativeResize(Eigen::NoChange, kept);
  }
  return block;
}

// `image`: the matrix times `basis`.
Eigenpairs leading_eigenpairs(const Eigen::MatrixXd& matrix, const Eigen::Index count)
{
  const Eigen::Index n = matrix.rows(), width = (std::max)(Eigen::Index(8), count);
  const double tolerance = 1e-13 * matrix.norm();
  Eigen::MatrixXd block(n, width), basis(n, n / 2 + width), image(n, n / 2 + width);
  std::mt19937 random; // the same numbers everywhere
  std::generate_n(block.data(), block.size(), [&] { return random() / 2147483648. - 1; });
  block = new_directions(block, basis.leftCols(0), 0);
  for(Eigen::Index m = 0, next_check = 4 * width; m <= n / 2;)
  {
    basis.middleCols(m, block.cols()) = block;
    image.middleCols(m, block.cols()) = product(matrix, block);
    m += block.cols();
    block = new_directions(image.middleCols(m - block.cols(), block.cols()), basis.leftCols(m),
                           tolerance);
    if(m < next_check && block.cols() > 0)
      continue;
    next_check = m + m / 4;
    Eigenpairs result = largest_of_all_eigenpairs(
      product_of_transposed(basis.leftCols(m), image.leftCols(m)), count);
    result.vectors = product(basis.leftCols(m), result.vectors);
    const Eigen::MatrixXd residuals
      = product(matrix, result.vectors) - result.vectors * result.values.asDiagonal();
    if(block.cols() == 0 || residuals.colwise().norm().maxCoeff() <= tolerance)
      return result;
  }
  return largest_of_all_eigenpairs(matrix, count);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
