// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANES_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cstddef>
#include <vector>

// Eight right-hand sides, or fields, are worked on at once. They are stored row by row, so that the
// eight numbers of a row lie side by side: lane k of all rows is column k. All lanes go through the
// same operations in the same order; hence a column has the same bytes in whichever lane it is, and
// whatever the others hold.
//
// A kernel is a class with a function `template <class Vector> static void run(...)` marked as one.
// `run_kernel()` calls the version that was compiled for the widest vectors of the processor.

#if defined(__GNUC__)
#define CGAL_CANONICAL_POSE_3_KERNEL [[gnu::always_inline]]
#else
#define CGAL_CANONICAL_POSE_3_KERNEL
#endif

#if defined(__GNUC__) && defined(__x86_64__)
#define CGAL_CANONICAL_POSE_3_HAS_X86_KERNELS
#endif

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

constexpr std::size_t NUMBER_OF_LANES = 8;

// eight numbers per row
using Lane_rows = std::vector<double>;

// What is computed with at once: SIZE numbers, of which ROWS rows are summed up side by side. `Bits`
// are unsigned integers of the same size. Addresses need not be multiples of the size.
struct Vector_of_1
{
  using Numbers = double;
  using Bits = unsigned long long;
  static constexpr std::size_t SIZE = 1, ROWS = 4;
};
#if defined(__GNUC__)
#define CGAL_CANONICAL_POSE_3_VECTOR(TYPE, BYTES)                                                  \
  typedef TYPE __attribute__((vector_size(BYTES), aligned(8), may_alias))
struct Vector_of_2
{
  CGAL_CANONICAL_POSE_3_VECTOR(double, 16) Numbers;
  CGAL_CANONICAL_POSE_3_VECTOR(unsigned long long, 16) Bits;
  static constexpr std::size_t SIZE = 2, ROWS = 8;
};
struct Vector_of_4
{
  CGAL_CANONICAL_POSE_3_VECTOR(double, 32) Numbers;
  CGAL_CANONICAL_POSE_3_VECTOR(unsigned long long, 32) Bits;
  static constexpr std::size_t SIZE = 4, ROWS = 8;
};
struct Vector_of_8
{
  CGAL_CANONICAL_POSE_3_VECTOR(double, 64) Numbers;
  CGAL_CANONICAL_POSE_3_VECTOR(unsigned long long, 64) Bits;
  static constexpr std::size_t SIZE = 8, ROWS = 8;
};
using Portable_vector = Vector_of_2;
#else
using Portable_vector = Vector_of_1;
#endif

#ifdef CGAL_CANONICAL_POSE_3_HAS_X86_KERNELS

template <class Kernel, class... Arguments>
__attribute__((target("avx512f,fma"))) void run_with_avx512(Arguments... arguments)
{
  Kernel::template run<Vector_of_8>(arguments...);
}

template <class Kernel, class... Arguments>
__attribute__((target("avx2,fma"))) void run_with_avx2(Arguments... arguments)
{
  Kernel::template run<Vector_of_4>(arguments...);
}

#endif

template <class Kernel, class... Arguments>
void run_kernel(Arguments... arguments)
{
#ifdef CGAL_CANONICAL_POSE_3_HAS_X86_KERNELS
  if(__builtin_cpu_supports("avx512f"))
    return run_with_avx512<Kernel>(arguments...);
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return run_with_avx2<Kernel>(arguments...);
#endif
  Kernel::template run<Portable_vector>(arguments...);
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANES_H
