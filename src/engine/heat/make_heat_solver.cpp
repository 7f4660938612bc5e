// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gradient_field.h"
#include "heat_lengths.h"
#include "../intrinsic/cotangent_operators.h"
#include "../support/in_parallel.h"

#include <CGAL/Canonical_pose_3/internal/heat/Heat_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Both matrices are block diagonal over the components of the mesh, and each component has its own
// time step, see heat_lengths(). They are factored in parallel. Sources are processed in blocks of
// eight, one per lane, and blocks in parallel.
class Intrinsic_heat_solver final : public Heat_solver
{
public:
  Intrinsic_heat_solver(const Face_corners& corners, const Point_matrix& points,
                        const double time_step_factor, const Factor_maker factor_maker)
    : m_surface(corners, points), m_heat(factor_maker()), m_poisson(factor_maker())
  {
    const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(triangulation());
    in_parallel(
      [&] {
        const Eigen::SparseMatrix<double> heat
          = heat_matrix(laplacian, heat_lengths(triangulation(), components(), time_step_factor));
        m_heat_diagonal = heat.diagonal();
        check(m_heat->factor(heat), "heat equation is not positive definite");
      },
      [&] {
        m_field = Gradient_field(triangulation());
        check(m_poisson->factor(pinned(laplacian)), "Poisson equation is not positive definite");
      });
  }

  const Intrinsic_triangulation& triangulation() const override
  {
    return m_surface.triangulation();
  }

  Eigen::MatrixXd distances(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::MatrixXd result(m_heat_diagonal.size(), static_cast<Eigen::Index>(sources.size()));
    for_each_block_of_fields(sources, [&](const Eigen::Index first, const Eigen::MatrixXd& fields) {
      result.middleCols(first, fields.cols()) = fields;
    });
    return result;
  }

  Eigen::VectorXd distance_to_nearest(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(m_heat_diagonal.size(), UNREACHED);
    std::mutex mutex;
    for_each_block_of_fields(sources, [&](Eigen::Index, const Eigen::MatrixXd& fields) {
      const std::lock_guard<std::mutex> lock(mutex);
      result = result.cwiseMin(fields.rowwise().minCoeff());
    });
    return result;
  }

private:
  static constexpr double UNREACHED = (std::numeric_limits<double>::infinity)();

  struct Workspace
  {
    Eigen::MatrixXd right_hand_sides, fields; // one per column
    Lane_rows heat, divergence;
  };

  const Vertex_components& components() const { return m_surface.components(); }

  void check(bool is_factored, const char* what) const
  {
    if(!is_factored)
      throw std::runtime_error(std::string("the matrix of the ") + what + " (" + m_heat->name()
                               + ")");
  }

  // M + diag(t) L: symmetric, since t is constant on a component, and positive definite. An
  // isolated vertex, which has neither mass nor neighbors, gets a 1.
  Eigen::SparseMatrix<double> heat_matrix(const Eigen::SparseMatrix<double>& laplacian,
                                          const std::vector<double>& lengths) const
  {
    const Eigen::VectorXd mass = lumped_mass(triangulation());
    Eigen::SparseMatrix<double> matrix = laplacian;
    for(Eigen::Index i = 0; i < matrix.cols(); ++i)
    {
      const double h = lengths[static_cast<std::size_t>(components()[i])];
      for(Eigen::SparseMatrix<double>::InnerIterator it(matrix, i); it; ++it)
      {
        it.valueRef() *= h * h;
        if(it.row() == i)
          it.valueRef() += mass[i] > 0 ? mass[i] : 1.;
      }
    }
    return matrix;
  }

  // Adds a positive number to one diagonal entry per component. This makes the matrix positive
  // definite without changing the solution: by summing the equations of the component, the number
  // times the value at this vertex equals the sum of the right-hand side, which is 0 for a
  // divergence.
  Eigen::SparseMatrix<double> pinned(Eigen::SparseMatrix<double> laplacian) const
  {
    for(int v : components().first_vertices())
    {
      double& entry = laplacian.coeffRef(v, v);
      entry += entry > 0 ? entry : 1.;
    }
    return laplacian;
  }

  // Calls f(first, fields) with the distances from sources first, first + 1, ..., one per column, in
  // any order and from several threads at once.
  template <class Function>
  void for_each_block_of_fields(const std::vector<Eigen::Index>& sources, const Function& f) const
  {
    const std::size_t number_of_blocks = (sources.size() + NUMBER_OF_LANES - 1) / NUMBER_OF_LANES;
    const auto call = [&](std::size_t block, Workspace& workspace) {
      const std::size_t first = block * NUMBER_OF_LANES;
      const std::size_t width = (std::min)(NUMBER_OF_LANES, sources.size() - first);
      solve(sources.data() + first, static_cast<Eigen::Index>(width), workspace);
      f(static_cast<Eigen::Index>(first), workspace.fields);
    };
#ifdef CGAL_LINKED_WITH_TBB
    tbb::enumerable_thread_specific<Workspace> workspaces;
    for_each_index(number_of_blocks, [&](std::size_t block) {
      // a solver waiting for its own tasks must not start another block in this workspace
      tbb::this_task_arena::isolate([&] { call(block, workspaces.local()); });
    });
#else
    Workspace workspace;
    for(std::size_t block = 0; block < number_of_blocks; ++block)
      call(block, workspace);
#endif
  }

  void solve(const Eigen::Index* const sources, const Eigen::Index width,
             Workspace& workspace) const
  {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, NUMBER_OF_LANES, Eigen::RowMajor>;
    const Eigen::Index n = m_heat_diagonal.size();
    auto& [right_hand_sides, fields, heat, divergence] = workspace;
    heat.assign(NUMBER_OF_LANES * static_cast<std::size_t>(n), 0.);
    divergence.assign(NUMBER_OF_LANES * static_cast<std::size_t>(n), 0.);
    right_hand_sides.setZero(n, width);
    for(Eigen::Index k = 0; k < width; ++k) // heat on the order of 1 at the source
      right_hand_sides(sources[k], k) = m_heat_diagonal[sources[k]];
    solve(*m_heat, "heat", right_hand_sides, fields);
    Eigen::Map<Rows>(heat.data(), n, NUMBER_OF_LANES).leftCols(width) = fields;
    m_field.divergence_of_unit_descent(heat, divergence);
    right_hand_sides = Eigen::Map<Rows>(divergence.data(), n, NUMBER_OF_LANES).leftCols(width);
    solve(*m_poisson, "Poisson", right_hand_sides, fields);
    for(Eigen::Index k = 0; k < width; ++k)
      finish(sources[k], fields.col(k));
  }

  static void solve(const Factor_base& factor, const char* const name,
                    const Eigen::MatrixXd& right_hand_sides, Eigen::MatrixXd& solutions)
  {
    if(!factor.solve(right_hand_sides, solutions) || !solutions.allFinite())
      throw std::runtime_error("a solution for the matrix of the " + std::string(name)
                               + " equation is not finite (" + factor.name() + ")");
  }

  // Converts a potential to distances: 0 at the source, infinite on other components.
  void finish(const Eigen::Index source, Eigen::Ref<Eigen::VectorXd> field) const
  {
    field = (field.array() - field[source]).cwiseMax(0);
    multiply_by_power_of_two(field, m_surface.exponent());
    if(components().size() > 1)
      for(Eigen::Index i = 0; i < field.size(); ++i)
        if(components()[i] != components()[source])
          field[i] = UNREACHED;
  }

  Delaunay_surface m_surface;
  Eigen::VectorXd m_heat_diagonal;
  std::unique_ptr<Factor_base> m_heat, m_poisson;
  Gradient_field m_field;
};

std::unique_ptr<Heat_solver> make_heat_solver(const Face_corners& corners,
                                              const Point_matrix& points,
                                              const double time_step_factor,
                                              const Factor_maker factor_maker)
{
  check_time_step_factor(time_step_factor);
  return std::make_unique<Intrinsic_heat_solver>(corners, points, time_step_factor, factor_maker);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
