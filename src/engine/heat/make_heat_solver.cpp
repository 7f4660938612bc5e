// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gradient_field.h"
#include "heat_lengths.h"
#include "../intrinsic/cotangent_operators.h"
#include "../support/in_parallel.h"

#include <CGAL/Canonical_pose_3/internal/heat/Heat_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lane_factor.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Both matrices are block diagonal over the components of the mesh, and each component has its own
// time step, see heat_lengths(). They have the same sparsity pattern, which is analyzed once, and
// are factored in parallel. Sources are processed in blocks of eight, one per lane, and blocks in
// parallel.
class Intrinsic_heat_solver final : public Heat_solver
{
public:
  Intrinsic_heat_solver(const Face_corners& corners, const Point_matrix& points,
                        const double time_step_factor, const Lane_factor_maker factor_maker)
    : m_surface(corners, points), m_heat(factor_maker())
  {
    const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(triangulation());
    std::vector<double> lengths;
    in_parallel([&] { m_heat->analyze(laplacian); },
                [&] { lengths = heat_lengths(triangulation(), components(), time_step_factor); });
    m_poisson = m_heat->copy();
    m_places = m_heat->places();
    in_parallel(
      [&] {
        const Eigen::SparseMatrix<double> heat = heat_matrix(laplacian, lengths);
        m_heat_diagonal = heat.diagonal();
        check(m_heat->factor(heat), "heat equation is not positive definite");
      },
      [&] {
        m_field = Gradient_field(triangulation(), m_places);
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
    for_each_block_of_fields(sources, [&](std::size_t first, std::size_t width, Lane_rows& rows) {
      for(Eigen::Index i = 0; i < result.rows(); ++i)
      {
        const double* const row = lanes(rows, i);
        for(std::size_t k = 0; k < width; ++k)
          result(i, static_cast<Eigen::Index>(first + k)) = row[k];
      }
    });
    return result;
  }

  Eigen::VectorXd distance_to_nearest(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(m_heat_diagonal.size(), UNREACHED);
    std::mutex mutex;
    for_each_block_of_fields(sources, [&](std::size_t, std::size_t width, Lane_rows& rows) {
      const std::lock_guard<std::mutex> lock(mutex);
      for(Eigen::Index i = 0; i < result.size(); ++i)
      {
        const double* const row = lanes(rows, i);
        result[i] = (std::min)(result[i], *std::min_element(row, row + width));
      }
    });
    return result;
  }

private:
  static constexpr double UNREACHED = (std::numeric_limits<double>::infinity)();

  struct Workspace
  {
    Lane_rows heat, potential;
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

  double* lanes(Lane_rows& rows, Eigen::Index vertex) const
  {
    return rows.data()
           + NUMBER_OF_LANES * static_cast<std::size_t>(m_places[static_cast<std::size_t>(vertex)]);
  }

  // Calls f(first, width, rows) with the distances from sources first .. first + width - 1 in the
  // first lanes of rows, in any order and from several threads at once.
  template <class Function>
  void for_each_block_of_fields(const std::vector<Eigen::Index>& sources, const Function& f) const
  {
    const std::size_t number_of_blocks = (sources.size() + NUMBER_OF_LANES - 1) / NUMBER_OF_LANES;
    const auto call = [&](std::size_t block, Workspace& workspace) {
      const std::size_t first = block * NUMBER_OF_LANES;
      const std::size_t width = (std::min)(NUMBER_OF_LANES, sources.size() - first);
      solve(sources.data() + first, width, workspace);
      f(first, width, workspace.potential);
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

  void solve(const Eigen::Index* sources, std::size_t width, Workspace& workspace) const
  {
    const std::size_t size = NUMBER_OF_LANES * m_places.size();
    workspace.heat.assign(size, 0.);
    workspace.potential.assign(size, 0.);
    for(std::size_t k = 0; k < width; ++k) // heat on the order of 1 at the source
      lanes(workspace.heat, sources[k])[k] = m_heat_diagonal[sources[k]];
    m_heat->solve(workspace.heat, width);
    m_field.divergence_of_unit_descent(workspace.heat, workspace.potential);
    m_poisson->solve(workspace.potential, width);
    finish(sources, width, workspace.potential);
  }

  // Converts potentials to distances: 0 at the source, infinite on other components.
  void finish(const Eigen::Index* sources, std::size_t width, Lane_rows& rows) const
  {
    std::array<double, NUMBER_OF_LANES> offsets = {};
    for(std::size_t k = 0; k < width; ++k)
      offsets[k] = lanes(rows, sources[k])[k];
    const int exponent = m_surface.exponent();
    // two factors, since a single one may be out of range
    const double first_factor = std::ldexp(1., exponent / 2);
    const double second_factor = std::ldexp(1., exponent - exponent / 2);
    std::array<double, NUMBER_OF_LANES> sums = {};
    for(std::size_t i = 0; i < rows.size(); i += NUMBER_OF_LANES)
      for(std::size_t k = 0; k < NUMBER_OF_LANES; ++k)
      {
        const double distance = (std::max)(rows[i + k] - offsets[k], 0.);
        sums[k] += distance;
        rows[i + k] = distance * first_factor * second_factor;
      }
    if(!std::isfinite(std::accumulate(sums.begin(), sums.end(), 0.)))
      throw std::runtime_error(
        std::string("a solution for the matrix of the Poisson equation is not finite (")
        + m_heat->name() + ")");
    if(components().size() > 1)
      for(Eigen::Index i = 0; i < m_heat_diagonal.size(); ++i)
        for(std::size_t k = 0; k < width; ++k)
          if(components()[i] != components()[sources[k]])
            lanes(rows, i)[k] = UNREACHED;
  }

  Delaunay_surface m_surface;
  Eigen::VectorXd m_heat_diagonal;
  std::unique_ptr<Lane_factor_base> m_heat, m_poisson;
  std::vector<int> m_places; // of the vertices among the rows of the factors
  Gradient_field m_field;
};

std::unique_ptr<Heat_solver> make_heat_solver(const Face_corners& corners,
                                              const Point_matrix& points,
                                              const double time_step_factor,
                                              const Lane_factor_maker factor_maker)
{
  check_time_step_factor(time_step_factor);
  return std::make_unique<Intrinsic_heat_solver>(corners, points, time_step_factor, factor_maker);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
