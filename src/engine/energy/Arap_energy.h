// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_ENERGY_ARAP_ENERGY_H
#define CANONICAL_POSE_3_ENGINE_ENERGY_ARAP_ENERGY_H

#include "Elastic_cell.h"
#include "../linear_algebra/Column_sums.h"

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The gradients of deformations, from the edges from vertex 3 of eight cells (matrix entry (k, c):
// coordinate c of the edge to vertex k).
struct Deformation_gradients
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const double* edges, const double* gradients,
                                                double* f)
  {
    for(std::size_t p = 0; p < NUMBER_OF_PARTS<Vector>; ++p)
    {
      Matrix_3<Vector> e, g;
      load_matrices<Vector>(edges, p, e);
      load_matrices<Vector>(gradients, p, g);
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          part<Vector>(f, 3 * i + j, p).numbers = e.entries[0][i] * g.entries[0][j]
                                                  + e.entries[1][i] * g.entries[1][j]
                                                  + e.entries[2][i] * g.entries[2][j];
    }
  }
};

// Of eight cells: |F - R|^2, det F (one row each), and w G^t R (twelve rows: three coordinates of
// each vertex).
struct Rotation_terms
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void
  run(const double* deformations, const double* rotations, const double* gradients,
      const double* weights, double* differences, double* determinants, double* terms)
  {
    using Numbers = typename Vector::Numbers;
    for(std::size_t p = 0; p < NUMBER_OF_PARTS<Vector>; ++p)
    {
      Matrix_3<Vector> f, r, g;
      load_matrices<Vector>(deformations, p, f);
      load_matrices<Vector>(rotations, p, r);
      load_matrices<Vector>(gradients, p, g);
      Numbers difference = {};
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          difference += (f.entries[i][j] - r.entries[i][j]) * (f.entries[i][j] - r.entries[i][j]);
      part<Vector>(differences, 0, p).numbers = difference;
      part<Vector>(determinants, 0, p).numbers
        = f.entries[0][0] * (f.entries[1][1] * f.entries[2][2] - f.entries[1][2] * f.entries[2][1])
          + f.entries[0][1]
              * (f.entries[1][2] * f.entries[2][0] - f.entries[1][0] * f.entries[2][2])
          + f.entries[0][2]
              * (f.entries[1][0] * f.entries[2][1] - f.entries[1][1] * f.entries[2][0]);
      const Numbers weight = part<Vector>(weights, 0, p).numbers;
      for(std::size_t c = 0; c < 3; ++c)
      {
        Numbers sum = {};
        for(std::size_t k = 0; k < 3; ++k)
        {
          const Numbers term
            = weight
              * (r.entries[c][0] * g.entries[k][0] + r.entries[c][1] * g.entries[k][1]
                 + r.entries[c][2] * g.entries[k][2]);
          part<Vector>(terms, 3 * k + c, p).numbers = term;
          sum += term;
        }
        part<Vector>(terms, 9 + c, p).numbers = -sum;
      }
    }
  }
};

// The as-rigid-as-possible energy of the cells, sum_t w_t |F_t - R_t|^2 (w_t with stiffness), and
// the data of its local and global steps. Cells are processed in packs of eight, one per lane. Each
// block of cells sums its part of sum_t w_t G_t^t R_t in its own slots, one per vertex of its cells;
// then the parts are summed per vertex. The order of all sums is thus fixed.
class Arap_energy
{
public:
  // The results of a local step, except for the rotations.
  struct Evaluation
  {
    double energy = 0;
    double volume_ratio = 0;
    std::size_t inverted = 0;
  };

  // `stiffness`: factors of the weights, or empty.
  Arap_energy(const Point_matrix& rest, const std::vector<std::array<int, 4>>& cells,
              const Eigen::VectorXd& weights, const Eigen::VectorXd& stiffness,
              const Rotation_routines& rotations = default_rotation_routines())
    : m_rotations(rotations), m_number_of_cells(cells.size()),
      m_packs((cells.size() + NUMBER_OF_LANES - 1) / NUMBER_OF_LANES)
  {
    for(std::size_t i = 0; i < NUMBER_OF_LANES * m_packs.size(); ++i)
    {
      const std::size_t t = (std::min)(i, cells.size() - 1); // copies of weight 0 pad the last pack
      Cell_pack& pack = m_packs[i / NUMBER_OF_LANES];
      const std::size_t lane = i % NUMBER_OF_LANES;
      Eigen::Matrix3d edges; // columns: the edges from vertex 3
      for(int k = 0; k < 3; ++k)
        edges.col(k) = rest.row(cells[t][k]) - rest.row(cells[t][3]);
      const Eigen::Matrix3d gradients = edges.inverse();
      if(!gradients.allFinite())
        throw std::invalid_argument("cell " + std::to_string(t) + " has no volume");
      set_matrix_of_lane(pack.gradients, lane, gradients);
      pack.volumes[lane] = i == t ? weights[static_cast<Eigen::Index>(t)] : 0;
      pack.weights[lane]
        = pack.volumes[lane] * (stiffness.size() > 0 ? stiffness[static_cast<Eigen::Index>(t)] : 1);
      for(int k = 0; k < 4; ++k)
        pack.vertices[k][lane] = cells[t][k];
    }
    assign_slots(static_cast<std::size_t>(rest.rows()));
  }

  const Rotation_routines& rotations() const { return m_rotations; }

  std::size_t number_of_cells() const { return m_number_of_cells; }

  Elastic_cell cell(const std::size_t t) const
  {
    const Cell_pack& pack = m_packs[t / NUMBER_OF_LANES];
    const std::size_t lane = t % NUMBER_OF_LANES;
    return {gradients(pack, lane),
            pack.weights[lane],
            {pack.vertices[0][lane], pack.vertices[1][lane], pack.vertices[2][lane],
             pack.vertices[3][lane]}};
  }

  // Returns sum_t w_t G_t^t G_t times `factor`, columns in parallel.
  Eigen::SparseMatrix<double> matrix(const double factor) const
  {
    const std::size_t n = m_slots_of_vertices.number_of_buckets();
    // corner k of cell t has index 4 t + k
    const Buckets<std::size_t> corners_of_vertices(n, [&](const auto& put) {
      for(std::size_t c = 0; c < 4 * m_number_of_cells; ++c)
        put(static_cast<std::size_t>(
              m_packs[c / 4 / NUMBER_OF_LANES].vertices[c % 4][c / 4 % NUMBER_OF_LANES]),
            c);
    });
    std::vector<std::vector<Eigen::Triplet<double>>> blocks(number_of_blocks(n));
    for_each_block(n, [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
      Column_sums column;
      for(std::size_t v = begin; v < end; ++v)
      {
        add_up(corners_of_vertices[v], factor, column);
        column.for_each([&](const int row, const double sum) {
          blocks[block].emplace_back(row, static_cast<int>(v), sum);
        });
      }
    });
    return assembled(n, blocks);
  }

  // Adds `factor` times sum_t w_t G_t^t R_t for the rotations of the last local step.
  void add_to_right_hand_side(const double factor, Point_matrix& right_hand_side) const
  {
    for_each_block(static_cast<std::size_t>(right_hand_side.rows()),
                   [&](std::size_t, const std::size_t begin, const std::size_t end) {
                     for(std::size_t v = begin; v < end; ++v)
                     {
                       std::array<double, 3> sum = {0, 0, 0};
                       for(const std::size_t slot : m_slots_of_vertices[v])
                         for(int c = 0; c < 3; ++c)
                           sum[c] += m_slots[slot][c];
                       for(int c = 0; c < 3; ++c)
                         right_hand_side(static_cast<Eigen::Index>(v), c) += factor * sum[c];
                     }
                   });
  }

  // The local step: finds the rotation closest to each gradient, and evaluates the energy with
  // them.
  Evaluation fit_rotations(const Point_matrix& points)
  {
    std::vector<Evaluation> blocks(number_of_blocks(m_number_of_cells));
    for_each_block(m_number_of_cells, [&](const std::size_t block, const std::size_t begin,
                                          const std::size_t end) {
      std::fill(m_slots.begin() + m_first_slot_of_block[block],
                m_slots.begin() + m_first_slot_of_block[block + 1], std::array<double, 3>{0, 0, 0});
      for(std::size_t t = begin; t < end; t += NUMBER_OF_LANES)
        fit_rotations(points, m_packs[t / NUMBER_OF_LANES], (std::min)(end - t, NUMBER_OF_LANES),
                      blocks[block]);
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
  static_assert(block_size % NUMBER_OF_LANES == 0, "a pack of cells lies in one block");

  struct Cell_pack
  {
    Lane_matrix gradients; // row k: gradient of the barycentric coordinate of vertex k
    std::array<double, NUMBER_OF_LANES> volumes; // shares of the rest volume
    std::array<double, NUMBER_OF_LANES> weights; // volumes times stiffness
    std::array<std::array<int, NUMBER_OF_LANES>, 4> vertices;
    std::array<std::array<int, NUMBER_OF_LANES>, 4> slots;
  };

  // Row k: gradient of the barycentric coordinate of vertex k.
  static Eigen::Matrix<double, 4, 3> gradients(const Cell_pack& pack, const std::size_t lane)
  {
    Eigen::Matrix<double, 4, 3> result;
    result.topRows<3>() = matrix_of_lane(pack.gradients, lane);
    result.row(3) = -result.topRows<3>().colwise().sum();
    return result;
  }

  // The entries of a row are summed in the order of the corners.
  template <class Corners>
  void add_up(const Corners& corners, const double factor, Column_sums& column) const
  {
    column.start(4 * corners.size());
    for(const std::size_t corner : corners)
    {
      const Cell_pack& pack = m_packs[corner / 4 / NUMBER_OF_LANES];
      const std::size_t lane = corner / 4 % NUMBER_OF_LANES;
      const Eigen::Matrix<double, 4, 3> g = gradients(pack, lane);
      const Eigen::Vector4d entries
        = factor * pack.weights[lane] * (g * g.row(corner % 4).transpose());
      for(int i = 0; i < 4; ++i)
        column[pack.vertices[i][lane]] += entries[i];
    }
  }

  static Eigen::SparseMatrix<double>
  assembled(const std::size_t n, const std::vector<std::vector<Eigen::Triplet<double>>>& blocks)
  {
    Eigen::SparseMatrix<double> result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    std::size_t size = 0;
    for(const auto& block : blocks)
      size += block.size();
    result.reserve(static_cast<Eigen::Index>(size));
    Eigen::Index started = 0;
    for(const auto& block : blocks)
      for(const Eigen::Triplet<double>& entry : block)
      {
        for(; started <= entry.col(); ++started)
          result.startVec(started);
        result.insertBack(entry.row(), entry.col()) = entry.value();
      }
    result.finalize();
    return result;
  }

  void assign_slots(const std::size_t number_of_vertices)
  {
    std::vector<int> vertices; // of the slots
    std::vector<int> slot(number_of_vertices, -1);
    for(std::size_t p = 0; p < m_packs.size(); ++p)
    {
      if(p % (block_size / NUMBER_OF_LANES) == 0)
        m_first_slot_of_block.push_back(vertices.size());
      for(int k = 0; k < 4; ++k)
        for(std::size_t lane = 0; lane < NUMBER_OF_LANES; ++lane)
        {
          const int v = m_packs[p].vertices[k][lane];
          if(slot[v] < static_cast<int>(m_first_slot_of_block.back()))
          {
            slot[v] = static_cast<int>(vertices.size());
            vertices.push_back(v);
          }
          m_packs[p].slots[k][lane] = slot[v];
        }
    }
    m_first_slot_of_block.push_back(vertices.size());
    m_slots.resize(vertices.size());
    m_slots_of_vertices = Buckets<std::size_t>(number_of_vertices, [&](const auto& put) {
      for(std::size_t s = 0; s < vertices.size(); ++s)
        put(static_cast<std::size_t>(vertices[s]), s);
    });
  }

  void fit_rotations(const Point_matrix& points, const Cell_pack& cells,
                     const std::size_t number_of_cells, Evaluation& sum)
  {
    Lane_matrix edges, f, r;
    for(std::size_t lane = 0; lane < NUMBER_OF_LANES; ++lane)
    {
      const Eigen::RowVector3d origin = points.row(cells.vertices[3][lane]);
      for(std::size_t k = 0; k < 3; ++k)
      {
        const Eigen::RowVector3d edge = points.row(cells.vertices[k][lane]) - origin;
        for(std::size_t c = 0; c < 3; ++c)
          edges[NUMBER_OF_LANES * (3 * k + c) + lane] = edge[static_cast<Eigen::Index>(c)];
      }
    }
    run_routine<Deformation_gradients>(edges.data(), cells.gradients.data(), f.data());
    m_rotations.eight(f, r);
    std::array<double, NUMBER_OF_LANES> differences, determinants;
    std::array<double, 12 * NUMBER_OF_LANES> terms;
    run_routine<Rotation_terms>(f.data(), r.data(), cells.gradients.data(), cells.weights.data(),
                                differences.data(), determinants.data(), terms.data());
    for(std::size_t lane = 0; lane < NUMBER_OF_LANES; ++lane)
    {
      sum.energy += cells.weights[lane] * differences[lane];
      sum.volume_ratio += cells.volumes[lane] * determinants[lane];
      sum.inverted += lane < number_of_cells && !(determinants[lane] > 0) ? 1 : 0;
      for(std::size_t k = 0; k < 4; ++k)
        for(std::size_t c = 0; c < 3; ++c)
          m_slots[static_cast<std::size_t>(cells.slots[k][lane])][c]
            += terms[NUMBER_OF_LANES * (3 * k + c) + lane];
    }
  }

  Rotation_routines m_rotations;
  std::size_t m_number_of_cells;
  std::vector<Cell_pack> m_packs;
  std::vector<std::array<double, 3>> m_slots; // of consecutive blocks
  std::vector<std::size_t> m_first_slot_of_block;
  Buckets<std::size_t> m_slots_of_vertices;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_ENERGY_ARAP_ENERGY_H
