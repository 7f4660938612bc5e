// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INJECTIVE_INJECTIVE_PATCH_H
#define CANONICAL_POSE_3_ENGINE_INJECTIVE_INJECTIVE_PATCH_H

#include "Foldover_free_energy.h"
#include "Inversion_barrier.h"
#include "Inversion_penalty.h"
#include "../energy/Elastic_cell.h"
#include "../linear_algebra/Sparse_factor.h"

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/factor_failures.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A part of a body whose first m vertices are free to move while all others are fixed. At
// displacements d from the start, the energy is
//   d^t A d / 2 + d^t g + sum_t w_t (p(F_t) - trace(R_t^t F_t)),
// half of that of a registration up to a constant: A and g contain all quadratic terms, including
// the |F_t|^2 of the cells. The penalty p is a `Foldover_free_energy` or an `Inversion_barrier`.
class Injective_patch
{
public:
  // `points`: the free ones first. `matrix` and `gradient`: A, with an entry for any two vertices
  // of a cell, and g.
  Injective_patch(Point_matrix points, std::vector<Elastic_cell> cells,
                  Eigen::SparseMatrix<double> matrix, Point_matrix gradient,
                  const Rotation_routines& rotations, const Factor_maker factor_maker)
    : m_rotations(rotations), m_factor_maker(factor_maker), m_points(std::move(points)),
      m_start(m_points.topRows(gradient.rows())), m_cells(std::move(cells)),
      m_matrix(std::move(matrix)), m_gradient(std::move(gradient))
  {
    for(const Elastic_cell& cell : m_cells)
      m_total_weight += cell.weight;
  }

  // Free vertices first, then fixed ones.
  const Point_matrix& points() const { return m_points; }

  // The steps that were computed, times the number of cells and of nonzeros of A.
  std::size_t work() const
  {
    return m_steps * (m_cells.size() + static_cast<std::size_t>(m_matrix.nonZeros()));
  }

  // Untangles as many inverted and flat cells as possible in at most `steps` steps.
  void remove_foldovers(const int steps)
  {
    double epsilon = 1;
    for(int i = 0; i < steps && !(least_determinant() > POSITIVE); ++i)
    {
      if(!(descend(Foldover_free_energy(epsilon)).value_or(0) > 0))
        return;
      epsilon *= 1 - EPSILON_DECAY * m_length;
    }
  }

  // Decreases the energy as far as the barrier allows, in at most `steps` steps, unless a cell is
  // inverted or flat, and until the barrier cuts steps to almost nothing. Returns whether it has
  // converged, that is, the last step decreased it by little.
  bool descend_to_the_barrier(const int steps)
  {
    if(!(least_determinant() > 0))
      return false;
    for(int i = 0; i < steps; ++i)
    {
      const std::optional<double> decrease = descend(Inversion_barrier());
      if(!decrease || !(*decrease > TOLERANCE * m_total_weight))
        return decrease.has_value();
      if(m_length < SHORTEST)
        return false;
    }
    return false;
  }

  // Half the energy with the penalty.
  double energy(const Point_matrix& points, const Inversion_penalty& penalty) const
  {
    const Point_matrix d = points.topRows(free()) - m_start;
    const Point_matrix product = m_matrix * d;
    double result = d.cwiseProduct(0.5 * product + m_gradient).sum();
    for(const Elastic_cell& cell : m_cells)
    {
      const Eigen::Matrix3d f = cell.deformation(points);
      result += cell.weight * (penalty.value(f) - f.cwiseProduct(m_rotations.one(f)).sum());
    }
    return result;
  }

  // Its gradient with respect to the free points.
  Point_matrix gradient(const Point_matrix& points, const Inversion_penalty& penalty) const
  {
    Point_matrix result = m_matrix * (points.topRows(free()) - m_start) + m_gradient;
    for(const Elastic_cell& cell : m_cells)
    {
      const Eigen::Matrix3d f = cell.deformation(points);
      const Eigen::Matrix3d stress = cell.weight * (penalty.gradient(f) - m_rotations.one(f));
      for(int k = 0; k < 4; ++k)
        if(cell.vertices[k] < free())
          result.row(cell.vertices[k]) += cell.gradients.row(k) * stress.transpose();
    }
    return result;
  }

private:
  static constexpr double POSITIVE = 1e-3, EPSILON_DECAY = 0.4, TOLERANCE = 1e-4;
  static constexpr double SHORTEST = 1e-4; // step that is worth its time, by a full one

  int free() const { return static_cast<int>(m_gradient.rows()); }

  double least_determinant() const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const Elastic_cell& cell : m_cells)
      result = (std::min)(result, cell.deformation(m_points).determinant());
    return result;
  }

  // A step of Newton's method; returns the decrease of the energy, or nothing if the step could not
  // be computed.
  std::optional<double> descend(const Inversion_penalty& penalty)
  {
    ++m_steps;
    const double before = energy(m_points, penalty);
    const Point_matrix g = gradient(m_points, penalty);
    Point_matrix step;
    try
    {
      step = newton_step(penalty, g);
    }
    catch(const Ill_conditioned&)
    {
      return std::nullopt;
    }
    const double slope = g.cwiseProduct(step).sum();
    Point_matrix next = m_points;
    for(double length = 1; length > 1e-9; length /= 2)
    {
      next.topRows(free()) = m_points.topRows(free()) - length * step;
      const double after = energy(next, penalty);
      if(after <= before - 1e-4 * length * slope)
      {
        m_length = length;
        m_points.swap(next);
        return before - after;
      }
    }
    return 0;
  }

  Point_matrix newton_step(const Inversion_penalty& penalty, const Point_matrix& g) const
  {
    Sparse_factor factor(m_factor_maker);
    factor.factor(hessian(penalty), "the matrix of a part of the body");
    const Eigen::VectorXd by_vertex = g.transpose().reshaped();
    const Eigen::VectorXd step = factor.solve(by_vertex);
    return step.reshaped(3, free()).transpose();
  }

  // Positive definite; the coordinates of a vertex are contiguous. The rotations are considered
  // constant.
  Eigen::SparseMatrix<double> hessian(const Inversion_penalty& penalty) const
  {
    Eigen::SparseMatrix<double> result(3 * free(), 3 * free());
    result.resizeNonZeros(9 * m_matrix.nonZeros());
    const int* const begin = m_matrix.outerIndexPtr();
    const int* const rows = m_matrix.innerIndexPtr();
    // the storage index of row 3 i of column 3 j + b for the entry e = (i, j) of A
    const auto place = [&](const int e, const int j, const int b) {
      return 9 * begin[j] + 3 * (b * (begin[j + 1] - begin[j]) + e - begin[j]);
    };
    for(int j = 0; j < free(); ++j)
      for(int b = 0; b < 3; ++b)
      {
        result.outerIndexPtr()[3 * j + b + 1] = place(begin[j + 1], j, b);
        for(int e = begin[j]; e < begin[j + 1]; ++e)
          for(int a = 0; a < 3; ++a)
          {
            result.innerIndexPtr()[place(e, j, b) + a] = 3 * rows[e] + a;
            result.valuePtr()[place(e, j, b) + a] = a == b ? m_matrix.valuePtr()[e] : 0;
          }
      }
    for(const Elastic_cell& cell : m_cells)
    {
      const Matrix_9 h = cell.weight * penalty.hessian(cell.deformation(m_points));
      if(h.isZero(0))
        continue;
      for(int l = 0; l < 4; ++l)
      {
        const int j = cell.vertices[l];
        if(j >= free())
          continue;
        Eigen::Matrix<double, 9, 3> column = Eigen::Matrix<double, 9, 3>::Zero();
        for(int i = 0; i < 3; ++i)
          column += cell.gradients(l, i) * h.middleCols<3>(3 * i);
        for(int k = 0; k < 4; ++k)
        {
          if(cell.vertices[k] >= free())
            continue;
          const int e = static_cast<int>(
            std::lower_bound(rows + begin[j], rows + begin[j + 1], cell.vertices[k]) - rows);
          for(int b = 0; b < 3; ++b)
            for(int i = 0; i < 3; ++i)
              for(int a = 0; a < 3; ++a)
                result.valuePtr()[place(e, j, b) + a]
                  += cell.gradients(k, i) * column(3 * i + a, b);
        }
      }
    }
    return result;
  }

  Rotation_routines m_rotations;
  Factor_maker m_factor_maker;
  Point_matrix m_points, m_start;
  std::vector<Elastic_cell> m_cells;
  Eigen::SparseMatrix<double> m_matrix;
  Point_matrix m_gradient;
  double m_total_weight = 0, m_length = 0;
  std::size_t m_steps = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INJECTIVE_INJECTIVE_PATCH_H
