// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_WORKSPACE_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_WORKSPACE_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/factor_failures.h>

#include <Eigen/Core>

#include <cholmod.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// CHOLMOD's settings and memory statistics. Each caller creates its own, since all calls modify it.
// It is for the functions cholmod_l_...; those with indices of type int, of which the results are the
// same bit for bit, refuse factors with more than 2^31 entries.
class Cholmod_common
{
public:
  Cholmod_common()
  {
    cholmod_l_start(&m_common);
    m_common.print = 0;
    // Column by column also after factoring in dense blocks: solves with those are not faster for a few
    // right-hand sides, and the bytes of a column depend on the others.
    m_common.final_asis = 0;
    m_common.final_ll = 0;
    m_common.final_super = 0;
    m_common.quick_return_if_not_posdef = 1;
    // Operations per nonzero from which dense blocks are faster. Measured (one thread): about 150;
    // surfaces of 26 000 / 90 000 / 360 000 vertices have 69 / 164 / 306, volumes of 9 000 / 27 000
    // have 440 / 650.
    m_common.supernodal = CHOLMOD_AUTO;
    m_common.supernodal_switch = 200;
  }
  ~Cholmod_common() { cholmod_l_finish(&m_common); }
  Cholmod_common(const Cholmod_common&) = delete;
  Cholmod_common& operator=(const Cholmod_common&) = delete;

  cholmod_common* get() { return &m_common; }

  // Throws if a call failed for another reason than the values of a matrix.
  void check(const std::size_t number_of_rows) const
  {
    // too large: for the address space
    if(m_common.status == CHOLMOD_OUT_OF_MEMORY || m_common.status == CHOLMOD_TOO_LARGE)
      throw_out_of_memory(number_of_rows, "CHOLMOD");
  }

private:
  cholmod_common m_common;
};

// Solves for one block of right-hand sides after the other, reusing the memory of the first.
class Cholmod_workspace
{
public:
  Cholmod_workspace() = default;
  ~Cholmod_workspace()
  {
    for(cholmod_dense** dense : {&m_solution, &m_first, &m_second})
      cholmod_l_free_dense(dense, m_common.get());
  }
  Cholmod_workspace(const Cholmod_workspace&) = delete;
  Cholmod_workspace& operator=(const Cholmod_workspace&) = delete;

  // All columns are solved for at the same time, so that CHOLMOD reads the factor once.
  bool solve(cholmod_factor* factor, const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
             Eigen::Ref<Eigen::MatrixXd> solutions)
  {
    cholmod_dense b = {};
    b.nrow = factor->n;
    b.ncol = static_cast<std::size_t>(right_hand_sides.cols());
    b.d = static_cast<std::size_t>(right_hand_sides.outerStride());
    b.nzmax = b.d * b.ncol;
    b.x = const_cast<double*>(right_hand_sides.data()); // read only
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    if(!cholmod_l_solve2(CHOLMOD_A, factor, &b, nullptr, &m_solution, nullptr, &m_first, &m_second,
                         m_common.get()))
    {
      m_common.check(factor->n);
      return false;
    }
    solutions = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(m_solution->x),
                                                  solutions.rows(), solutions.cols());
    return solutions.allFinite();
  }

private:
  Cholmod_common m_common;
  cholmod_dense* m_solution = nullptr;
  cholmod_dense* m_first = nullptr;
  cholmod_dense* m_second = nullptr;
};

} // namespace internal

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_WORKSPACE_H
