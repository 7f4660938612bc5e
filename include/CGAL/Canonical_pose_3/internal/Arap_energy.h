// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ARAP_ENERGY_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ARAP_ENERGY_H

#include <CGAL/Canonical_pose_3/internal/closest_rotation.h>
#include <CGAL/Canonical_pose_3/internal/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The as-rigid-as-possible energy of the cells, sum_t w_t |F_t - R_t|^2, and what its local and
// global steps need.
template <typename ClosestRotationTraits>
class Arap_energy
{
public:
  // What a local step finds, besides the rotations.
  struct Evaluation
  {
    double energy = 0;
    double volume_ratio = 0;
    std::size_t inverted = 0;
  };

  Arap_energy(const Point_matrix& rest, const std::vector<std::array<int, 4>>& cells,
              const Eigen::VectorXd& weights)
    : m_cells(cells), m_weights(weights), m_gradients(cells.size()),
      m_rotations(cells.size(), Eigen::Matrix3d::Identity())
  {
    for(std::size_t t = 0; t < cells.size(); ++t)
    {
      Eigen::Matrix3d edges; // columns: the edges from vertex 3
      for(int k = 0; k < 3; ++k)
        edges.col(k) = rest.row(cells[t][k]) - rest.row(cells[t][3]);
      m_gradients[t].topRows<3>() = edges.inverse();
      m_gradients[t].row(3) = -m_gradients[t].topRows<3>().colwise().sum();
      if(!m_gradients[t].allFinite())
        throw std::invalid_argument("cell " + std::to_string(t) + " has no volume");
    }
  }

  // Entries of sum_t w_t G_t^t G_t times `factor`.
  void add_to_matrix(const double factor, std::vector<Eigen::Triplet<double>>& matrix) const
  {
    for(std::size_t t = 0; t < m_cells.size(); ++t)
    {
      const Eigen::Matrix4d block
        = factor * m_weights[t] * m_gradients[t] * m_gradients[t].transpose();
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          matrix.emplace_back(m_cells[t][i], m_cells[t][j], block(i, j));
    }
  }

  // Adds `factor` times sum_t w_t G_t^t R_t for the rotations of the last local step.
  void add_to_right_hand_side(const double factor, Point_matrix& right_hand_side) const
  {
    for(std::size_t t = 0; t < m_cells.size(); ++t)
    {
      const Gradient rows = factor * m_weights[t] * m_gradients[t] * m_rotations[t].transpose();
      for(int i = 0; i < 4; ++i)
        right_hand_side.row(m_cells[t][i]) += rows.row(i);
    }
  }

  // The local step: stores the rotation closest to each gradient, and evaluates the energy with
  // them.
  Evaluation fit_rotations(const Point_matrix& points)
  {
    std::vector<Evaluation> blocks(number_of_blocks(m_cells.size()));
    for_each_block(m_cells.size(),
                   [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
                     for(std::size_t t = begin; t < end; ++t)
                     {
                       const Eigen::Matrix3d f = deformation_gradient(points, t);
                       m_rotations[t] = closest_rotation<ClosestRotationTraits>(f);
                       const double determinant = f.determinant();
                       blocks[block].energy += m_weights[t] * (f - m_rotations[t]).squaredNorm();
                       blocks[block].volume_ratio += m_weights[t] * determinant;
                       blocks[block].inverted += determinant > 0 ? 0 : 1;
                     }
                   });
    Evaluation sum;
    for(const Evaluation& e : blocks)
    {
      sum.energy += e.energy;
      sum.volume_ratio += e.volume_ratio;
      sum.inverted += e.inverted;
    }
    return sum;
  }

private:
  typedef Eigen::Matrix<double, 4, 3>
    Gradient; // row k: gradient of the barycentric coordinate of vertex k

  Eigen::Matrix3d deformation_gradient(const Point_matrix& points, const std::size_t t) const
  {
    Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
    for(int k = 0; k < 4; ++k)
      f.noalias() += points.row(m_cells[t][k]).transpose() * m_gradients[t].row(k);
    return f;
  }

  const std::vector<std::array<int, 4>>& m_cells;
  const Eigen::VectorXd& m_weights;
  std::vector<Gradient> m_gradients;
  std::vector<Eigen::Matrix3d> m_rotations;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ARAP_ENERGY_H
