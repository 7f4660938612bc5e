// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_STATE_OF_THE_PROCESS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_STATE_OF_THE_PROCESS_H

#include <mutex>

// State that exists once per process, independently of the configuration of its parts: not in their
// inline namespaces.
namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// METIS and TetGen seed and use std::rand(): only one at a time.
inline std::mutex& mutex_of_random_numbers()
{
  static std::mutex mutex;
  return mutex;
}

#if defined(__GNUC__) && !defined(_WIN32)
extern "C" {
int openblas_get_num_threads(void) __attribute__((weak));
void openblas_set_num_threads(int number_of_threads) __attribute__((weak));
}
#define CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENBLAS
#endif

#if defined(__GNUC__) && defined(__ELF__)
// Under other names, since <omp.h> declares the functions differently in each compiler.
extern "C" {
int canonical_pose_3_get_openmp_levels(void) __asm__("omp_get_max_active_levels")
  __attribute__((weak));
void canonical_pose_3_set_openmp_levels(int) __asm__("omp_set_max_active_levels")
  __attribute__((weak));
}
#define CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENMP
#endif

// During the lifetime of such an object, the libraries that this thread calls do not start threads of
// OpenMP. CHOLMOD factors with four, which wait for each other at full load.
class Openmp_off
{
public:
  Openmp_off()
  {
#ifdef CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENMP
    if(canonical_pose_3_get_openmp_levels != nullptr
       && canonical_pose_3_set_openmp_levels != nullptr)
      m_levels = canonical_pose_3_get_openmp_levels();
#endif
    set(0);
  }
  ~Openmp_off() { set(m_levels); }
  Openmp_off(const Openmp_off&) = delete;
  Openmp_off& operator=(const Openmp_off&) = delete;

private:
  void set([[maybe_unused]] const int levels) const
  {
#ifdef CGAL_CANONICAL_POSE_3_HAS_WEAK_OPENMP
    if(m_levels > 0)
      canonical_pose_3_set_openmp_levels(levels);
#endif
  }

  int m_levels = 0; // of the user
};

// During the lifetime of such objects, OpenBLAS, if it is the BLAS of this process, uses one
// thread: its sums depend on the number of threads. The first object saves the user's number, the
// last one restores it.
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

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_STATE_OF_THE_PROCESS_H
