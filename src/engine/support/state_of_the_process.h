// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_STATE_OF_THE_PROCESS_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_STATE_OF_THE_PROCESS_H

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

#if defined(__GNUC__) && defined(__ELF__)
// Null if the function is not part of this process. These are other names of the functions, so that
// the program's own references to them remain as they are, and headers that declare them differ.
[[maybe_unused]] static int get_openblas_threads()
  __attribute__((weakref("openblas_get_num_threads")));
[[maybe_unused]] static void set_openblas_threads(int)
  __attribute__((weakref("openblas_set_num_threads")));
[[maybe_unused]] static int get_openmp_levels()
  __attribute__((weakref("omp_get_max_active_levels")));
[[maybe_unused]] static void set_openmp_levels(int)
  __attribute__((weakref("omp_set_max_active_levels")));
#define CGAL_CANONICAL_POSE_3_HAS_WEAK_REFERENCES
#endif

// During the lifetime of such an object, the libraries that this thread calls do not start threads of
// OpenMP. CHOLMOD factors with four, which wait for each other at full load.
class Openmp_off
{
public:
  Openmp_off()
  {
#ifdef CGAL_CANONICAL_POSE_3_HAS_WEAK_REFERENCES
    if(get_openmp_levels != nullptr && set_openmp_levels != nullptr)
      m_levels = get_openmp_levels();
#endif
    set(0);
  }
  ~Openmp_off() { set(m_levels); }
  Openmp_off(const Openmp_off&) = delete;
  Openmp_off& operator=(const Openmp_off&) = delete;

private:
  void set([[maybe_unused]] const int levels) const
  {
#ifdef CGAL_CANONICAL_POSE_3_HAS_WEAK_REFERENCES
    if(m_levels > 0)
      set_openmp_levels(levels);
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
#ifdef CGAL_CANONICAL_POSE_3_HAS_WEAK_REFERENCES
    static std::mutex mutex;
    static int living = 0, saved = 1;
    if(get_openblas_threads == nullptr || set_openblas_threads == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(mutex);
    if(step > 0 && living == 0)
    {
      saved = get_openblas_threads();
      set_openblas_threads(1);
    }
    living += step;
    if(living == 0)
      set_openblas_threads(saved);
#endif
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_STATE_OF_THE_PROCESS_H
