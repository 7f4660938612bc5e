// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_LITERAL_REGISTRATION_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_LITERAL_REGISTRATION_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Real_timer.h>

#include "Sparse_system.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace Canonical_pose_benchmark {

/// The registration done literally as the paper prints it (Equations 6 to 13), as a reference: at
/// every iteration rotations by Eigen's JacobiSVD, one cell after the other, and the matrix alpha L
/// + (1 + beta) M assembled, analyzed, factored and solved with, although it never changes. Only
/// the inverse of the rest edges is kept, as the paper says. The sparse solver is the package's
/// own.
///
/// Cell and matching weights are shares with sum 1, so that the energy is that of the package; with
/// matching weights 1/n it is the paper's, divided by n.
class Literal_registration
{
public:
  using Point_matrix = CGAL::Canonical_pose_3::Point_matrix;
  using Body = CGAL::Canonical_pose_3::Conforming_body_3;

  /// How the unknowns are laid out. The paper's matrix has 3n rows; it is three times the same
  /// matrix of n rows, and who sees that factors a third.
  enum Unknowns { THREE_PER_VERTEX, ONE_PER_VERTEX };

  /// Seconds spent so far; the right-hand side counts with the rotations.
  struct Seconds
  {
    double rotations = 0, matrix = 0, solution = 0;
    double total() const { return rotations + matrix + solution; }
  };

  /// `weights`: one per surface vertex; `alpha`: in the squared unit of the mesh, detail length
  /// squared.
  Literal_registration(const Body& body, const Eigen::VectorXd& weights, const Point_matrix& target,
                       double alpha, double beta, Unknowns unknowns)
    : m_body(body), m_weights(Eigen::VectorXd::Zero(body.points().rows())),
      m_target(Point_matrix::Zero(body.points().rows(), 3)), m_alpha(alpha), m_beta(beta),
      m_unknowns(unknowns)
  {
    m_weights.head(weights.size()) = weights;
    m_target.topRows(target.rows()) = target;
    for(const std::array<int, 4>& c : body.cells())
    {
      const Eigen::Matrix3d inverse = edges(body.points(), c).inverse();
      m_gradients.emplace_back();
      m_gradients.back().topRows<3>() = inverse;
      m_gradients.back().row(3) = -inverse.colwise().sum();
    }
  }

  /// One iteration from `v`, rotations included.
  void iterate(Point_matrix& v)
  {
    CGAL::Real_timer timer;
    timer.start();
    Point_matrix right = m_weights.asDiagonal() * (m_target + m_beta * v);
    for(std::size_t t = 0; t < m_gradients.size(); ++t)
    {
      const Eigen::Matrix<double, 4, 3> rows = m_alpha * m_body.cell_weights()[t] * m_gradients[t]
                                               * rotation(gradient(v, t)).transpose();
      for(int k = 0; k < 4; ++k)
        right.row(m_body.cells()[t][k]) += rows.row(k);
    }
    m_seconds.rotations += timer.time();
    timer.reset();
    const Sparse_system system(matrix());
    m_seconds.matrix += timer.time();
    timer.reset();
    v = solve(system, right);
    m_seconds.solution += timer.time();
  }

  /// The energy at `v`, in the squared unit of the mesh.
  double energy(const Point_matrix& v) const
  {
    double sum = (v - m_target).rowwise().squaredNorm().dot(m_weights);
    for(std::size_t t = 0; t < m_gradients.size(); ++t)
    {
      const Eigen::Matrix3d f = gradient(v, t);
      sum += m_alpha * m_body.cell_weights()[t] * (f - rotation(f)).squaredNorm();
    }
    return sum;
  }

  const Seconds& seconds() const { return m_seconds; }

private:
  static Eigen::Matrix3d edges(const Point_matrix& v, const std::array<int, 4>& c)
  {
    Eigen::Matrix3d result;
    for(int k = 0; k < 3; ++k)
      result.col(k) = v.row(c[k]) - v.row(c[3]);
    return result;
  }

  Eigen::Matrix3d gradient(const Point_matrix& v, std::size_t t) const
  {
    return edges(v, m_body.cells()[t]) * m_gradients[t].topRows<3>();
  }

  static Eigen::Matrix3d rotation(const Eigen::Matrix3d& f)
  {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d u = svd.matrixU();
    if((u * svd.matrixV().transpose()).determinant() < 0)
      u.col(2) *= -1;
    return u * svd.matrixV().transpose();
  }

  Eigen::SparseMatrix<double> matrix() const
  {
    const int copies = m_unknowns == THREE_PER_VERTEX ? 3 : 1;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(copies
                    * (16 * m_gradients.size() + static_cast<std::size_t>(m_weights.size())));
    const auto add = [&](const int i, const int j, const double value) {
      for(int c = 0; c < copies; ++c)
        entries.emplace_back(copies * i + c, copies * j + c, value);
    };
    for(std::size_t t = 0; t < m_gradients.size(); ++t)
    {
      const Eigen::Matrix4d block
        = m_alpha * m_body.cell_weights()[t] * m_gradients[t] * m_gradients[t].transpose();
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          add(m_body.cells()[t][i], m_body.cells()[t][j], block(i, j));
    }
    for(int i = 0; i < static_cast<int>(m_weights.size()); ++i)
      add(i, i, (1 + m_beta) * m_weights[i]);
    Eigen::SparseMatrix<double> result(copies * m_weights.size(), copies * m_weights.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Point_matrix solve(const Sparse_system& system, const Point_matrix& right) const
  {
    if(m_unknowns == ONE_PER_VERTEX)
      return system.solve(right);
    const Eigen::Matrix3Xd columns = right.transpose();
    const Eigen::MatrixXd solution
      = system.solve(Eigen::Map<const Eigen::VectorXd>(columns.data(), columns.size()));
    return Eigen::Map<const Eigen::Matrix3Xd>(solution.data(), 3, right.rows()).transpose();
  }

  const Body& m_body;
  Eigen::VectorXd m_weights; // of all body vertices, 0 inside
  Point_matrix m_target;
  double m_alpha, m_beta;
  Unknowns m_unknowns;
  std::vector<Eigen::Matrix<double, 4, 3>>
    m_gradients; // row k: gradient of the barycentric coordinate of vertex k
  Seconds m_seconds;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_LITERAL_REGISTRATION_H
