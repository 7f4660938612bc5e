// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_CHOLMOD_WORKSPACE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_CHOLMOD_WORKSPACE_H

#include <Eigen/Core>

#include <cholmod.h>

#include <cstddef>
#include <mutex>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

#if defined(__GNUC__) && !defined(_WIN32)
extern "C" {
int openblas_get_num_threads(void) __attribute__((weak));
void openblas_set_num_threads(int number_of_threads) __attribute__((weak));
}
#define CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENBLAS
#endif

// While one of these lives, OpenBLAS, if it is the BLAS of this process, uses one thread: its sums,
// and so the bytes, depend on the number. The first one saves the user's number, the last one
// restores it.
class Single_threaded_blas
{
public:
  Single_threaded_blas() { count(+1); }
  ~Single_threaded_blas() { count(-1); }
  Single_threaded_blas(const Single_threaded_blas&) = delete;
  Single_threaded_blas& operator=(const Single_threaded_blas&) = delete;

private:
  static void count([[maybe_unused]] int step)
  {
#ifdef CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENBLAS
    static std::mutex mutex;
    static int living = 0, saved = 1;
    if(openblas_get_num_threads == nullptr || openblas_set_num_threads == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(mutex);
    if(step > 0 && living == 0)
    {
      saved = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
    living += step;
    if(living == 0)
      openblas_set_num_threads(saved);
#endif
  }
};

// CHOLMOD's settings and memory statistics. Everybody makes one of his own, since a common one
// would be written to by each call.
class Cholmod_common
{
public:
  Cholmod_common()
  {
    cholmod_start(&m_common);
    m_common.print = 0;
    m_common.final_ll = 0;
    m_common.quick_return_if_not_posdef = 1;
    // Operations per nonzero from which dense blocks pay. Measured (one thread): factoring is
    // faster from about 150 on, solving is slower below 300; surfaces of 26 000 / 90 000 / 360 000
    // vertices have 69 / 164 / 306, volumes of 9 000 / 27 000 have 440 / 650.
    m_common.supernodal = CHOLMOD_AUTO;
    m_common.supernodal_switch = 200;
  }
  ~Cholmod_common() { cholmod_finish(&m_common); }
  Cholmod_common(const Cholmod_common&) = delete;
  Cholmod_common& operator=(const Cholmod_common&) = delete;

  cholmod_common* get() { return &m_common; }

private:
  cholmod_common m_common;
};

// One block of right-hand sides after the other, with the memory of the first.
class Cholmod_workspace
{
public:
  Cholmod_workspace() = default;
  ~Cholmod_workspace()
  {
    for(cholmod_dense** dense : {&m_solution, &m_first, &m_second})
      cholmod_free_dense(dense, m_common.get());
  }
  Cholmod_workspace(const Cholmod_workspace&) = delete;
  Cholmod_workspace& operator=(const Cholmod_workspace&) = delete;

  // The columns are solved for at once: CHOLMOD then reads the factor once.
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
    if(!cholmod_solve2(CHOLMOD_A, factor, &b, nullptr, &m_solution, nullptr, &m_first, &m_second,
                       m_common.get()))
      return false;
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

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_CHOLMOD_WORKSPACE_H
