// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INJECTIVE_INJECTIVE_REPAIR_H
#define CANONICAL_POSE_3_ENGINE_INJECTIVE_INJECTIVE_REPAIR_H

#include "Injective_patch.h"
#include "../energy/Arap_energy.h"
#include "../energy/Elastic_cell.h"

#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Untangles inverted and flat cells of a registered body locally, in patches of rings around them,
// see `Injective_patch`; remaining ones are tried again in larger patches, as long as these are a
// minor part of the body. As a last resort, entire components start from a pose where no cell is
// inverted. Finally, the energy of all patches is decreased. All this is limited by the work, which
// is counted, not timed.
class Injective_repair
{
public:
  // `matrix`: that of the registration, which must outlive this object; `cell_factor`: factor of
  // the cell term, as in `matrix`.
  Injective_repair(const Arap_energy& arap, const double cell_factor,
                   const Eigen::SparseMatrix<double>& matrix, const Factor_maker factor_maker)
    : m_rotations(arap.rotations()), m_factor_maker(factor_maker), m_matrix(matrix)
  {
    for(std::size_t t = 0; t < arap.number_of_cells(); ++t)
      m_cells.push_back(arap.cell(t));
    for(Elastic_cell& cell : m_cells)
      cell.weight *= cell_factor;
  }

  // The outcome of the repair.
  struct Outcome
  {
    std::size_t restarted_vertices = 0;
    bool is_minimal = true; // the energy is minimal, given the barrier
  };

  // Returns a pose without inverted cells, which may be far, or nothing.
  using Start = std::function<std::optional<Point_matrix>()>;

  // `right_hand_side`: that of the registration without the cell term; `start`: called if inverted
  // cells remain. If it returns nothing, they do.
  Outcome operator()(const Point_matrix& right_hand_side, const Start& start,
                     Point_matrix& points) const
  {
    std::vector<bool> was_free(static_cast<std::size_t>(points.rows()), false);
    Outcome outcome;
    std::size_t work = 0;
    bool is_growing = true;
    for(int rings = 1; is_growing; rings *= 2)
    {
      std::vector<bool> is_free = vertices_of_inverted_cells(points);
      for(int ring = 0; ring < rings && is_growing; ++ring)
        is_growing = grow(is_free);
      const int steps = (std::min)(STEPS_OF_REMOVAL, steps_within(WORK_OF_REMOVAL, work, is_free));
      if(!is_growing || steps == 0
         || (rings > 1 && 2 * std::count(is_free.begin(), is_free.end(), true) > points.rows()))
        break;
      std::transform(is_free.begin(), is_free.end(), was_free.begin(), was_free.begin(),
                     std::logical_or<bool>());
      work += for_each_patch(is_free, right_hand_side, points,
                             [&](Injective_patch& patch) { patch.remove_foldovers(steps); });
    }
    std::vector<bool> inverted = vertices_of_inverted_cells(points);
    if(std::find(inverted.begin(), inverted.end(), true) != inverted.end())
    {
      const std::optional<Point_matrix> first = start();
      if(!first)
        return {0, false};
      while(grow(inverted)) // entire components
        ;
      for(std::size_t v = 0; v < inverted.size(); ++v)
        if(inverted[v])
        {
          points.row(static_cast<Eigen::Index>(v)) = first->row(static_cast<Eigen::Index>(v));
          was_free[v] = true;
          ++outcome.restarted_vertices;
        }
    }
    // the start is far from the minimum
    const int most_steps = outcome.restarted_vertices > 0 ? STEPS_AFTER_RESTART : STEPS_OF_A_PATCH;
    const int steps = (std::min)(most_steps, steps_within(WORK_OF_REPAIR, work, was_free));
    std::atomic<bool> is_minimal = true;
    for_each_patch(was_free, right_hand_side, points, [&](Injective_patch& patch) {
      if(!patch.descend_to_the_barrier(steps))
        is_minimal = false;
    });
    outcome.is_minimal = is_minimal;
    return outcome;
  }

private:
  // The most steps of a patch.
  static constexpr int STEPS_OF_REMOVAL = 20, STEPS_OF_A_PATCH = 50, STEPS_AFTER_RESTART = 500;

  // The limits of the work of all patches, without and with the final decrease of the energy, in
  // steps of the entire body. Such a step costs as much as some 20 iterations of a registration, which
  // has about 100. Bodies smaller than one of some 5000 cells may take as much work as it.
  static constexpr std::size_t WORK_OF_REMOVAL = 10, WORK_OF_REPAIR = 16, SMALL_SIZE = 20000;

  // The work of a step of all patches of free vertices: the number of cells and of nonzeros.
  std::size_t size(const std::vector<bool>& is_free) const
  {
    std::size_t result = 0;
    for(const Elastic_cell& cell : m_cells)
      result += std::any_of(cell.vertices.begin(), cell.vertices.end(),
                            [&](const int v) { return is_free[v]; });
    for(int j = 0; j < m_matrix.outerSize(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_matrix, j); it; ++it)
        result += is_free[j] && is_free[it.row()];
    return result;
  }

  // How many steps of all patches fit into the limit after `work`; 0 if no vertex is free.
  int steps_within(const std::size_t limit, const std::size_t work,
                   const std::vector<bool>& is_free) const
  {
    const std::size_t all
      = limit * (std::max)(SMALL_SIZE, size(std::vector<bool>(is_free.size(), true)));
    const std::size_t one = size(is_free);
    return one == 0 || all < work ? 0 : static_cast<int>((all - work) / one);
  }

  std::vector<bool> vertices_of_inverted_cells(const Point_matrix& points) const
  {
    std::vector<bool> result(static_cast<std::size_t>(points.rows()), false);
    for(const Elastic_cell& cell : m_cells)
      if(!(cell.deformation(points).determinant() > 0))
        for(const int v : cell.vertices)
          result[static_cast<std::size_t>(v)] = true;
    return result;
  }

  // Adds the vertices of all cells that have one of the vertices; returns whether any were added.
  bool grow(std::vector<bool>& vertices) const
  {
    const std::vector<bool> old = vertices;
    for(const Elastic_cell& cell : m_cells)
      if(std::any_of(cell.vertices.begin(), cell.vertices.end(),
                     [&](const int v) { return old[v]; }))
        for(const int v : cell.vertices)
          vertices[v] = true;
    return vertices != old;
  }

  // Calls the function for each patch (vertices connected through the matrix), and copies its
  // points back. Returns the work.
  template <class Function>
  std::size_t for_each_patch(const std::vector<bool>& is_free, const Point_matrix& right_hand_side,
                             Point_matrix& points, const Function& function) const
  {
    const std::size_t n = is_free.size();
    Disjoint_sets sets(n);
    for(int j = 0; j < m_matrix.outerSize(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_matrix, j); it; ++it)
        if(is_free[j] && is_free[it.row()])
          sets.unite(static_cast<std::size_t>(j), static_cast<std::size_t>(it.row()));
    std::vector<int> patch_of(n, -1); // of the free vertices
    int number_of_patches = 0;
    for(std::size_t v = 0; v < n; ++v)
      if(is_free[v])
      {
        int& p = patch_of[sets.representative(v)];
        if(p < 0)
          p = number_of_patches++;
        patch_of[v] = p;
      }
    const Buckets<int> vertices(number_of_patches, [&](const auto& put) {
      for(std::size_t v = 0; v < n; ++v)
        if(patch_of[v] >= 0)
          put(patch_of[v], static_cast<int>(v));
    });
    const Buckets<std::size_t> cells(number_of_patches, [&](const auto& put) {
      for(std::size_t t = 0; t < m_cells.size(); ++t)
        for(const int v : m_cells[t].vertices)
          if(patch_of[v] >= 0) // the other vertices are then fixed or in the same patch
          {
            put(patch_of[v], t);
            break;
          }
    });
    std::atomic<std::size_t> work = 0;
    // reads and writes points of this patch, and reads fixed points
    for_each_index(static_cast<std::size_t>(number_of_patches), [&](const std::size_t p) {
      Injective_patch patch = make_patch(vertices[p], cells[p], right_hand_side, points);
      function(patch);
      work += patch.work();
      int i = 0;
      for(const int v : vertices[p])
        points.row(v) = patch.points().row(i++);
    });
    return work;
  }

  template <class Vertices, class Cells>
  Injective_patch make_patch(const Vertices& free_vertices, const Cells& cells,
                             const Point_matrix& right_hand_side, const Point_matrix& points) const
  {
    std::vector<int> vertices(free_vertices.begin(), free_vertices.end());
    const int m = static_cast<int>(vertices.size());
    std::unordered_map<int, int> local;
    for(int i = 0; i < m; ++i)
      local.emplace(vertices[i], i);

    std::vector<Eigen::Triplet<double>> entries;
    Point_matrix gradient(m, 3);
    for(int j = 0; j < m; ++j)
    {
      gradient.row(j) = -right_hand_side.row(vertices[j]);
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_matrix, vertices[j]); it; ++it)
      {
        gradient.row(j) += it.value() * points.row(it.row());
        const auto free_row = local.find(static_cast<int>(it.row()));
        if(free_row != local.end())
          entries.emplace_back(free_row->second, j, it.value());
      }
    }
    Eigen::SparseMatrix<double> matrix(m, m);
    matrix.setFromTriplets(entries.begin(), entries.end());

    std::vector<Elastic_cell> patch_cells;
    for(const std::size_t t : cells)
    {
      patch_cells.push_back(m_cells[t]);
      for(int& v : patch_cells.back().vertices)
      {
        const auto [place, is_new] = local.emplace(v, static_cast<int>(vertices.size()));
        if(is_new)
          vertices.push_back(v);
        v = place->second;
      }
    }
    Point_matrix patch_points(static_cast<Eigen::Index>(vertices.size()), 3);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      patch_points.row(static_cast<Eigen::Index>(i)) = points.row(vertices[i]);
    return Injective_patch(std::move(patch_points), std::move(patch_cells), std::move(matrix),
                           std::move(gradient), m_rotations, m_factor_maker);
  }

  Rotation_routines m_rotations;
  Factor_maker m_factor_maker;
  const Eigen::SparseMatrix<double>& m_matrix;
  std::vector<Elastic_cell> m_cells;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INJECTIVE_INJECTIVE_REPAIR_H
