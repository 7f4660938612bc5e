// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANES_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

// Eight fields or matrices are processed at the same time. They are stored row by row, so
// that the eight numbers of a row are contiguous: lane k of all rows is column k. The same
// operations are applied to all lanes in the same order; hence a column has the same bytes in any
// lane, independently of the other lanes.
//
// A routine is a class with a function `template <class Vector> static void run(...)` marked as one.
// `run_routine()` calls the version that was compiled for the widest vectors of the processor.

#if defined(__GNUC__)
#define CGAL_CANONICAL_POSE_3_ROUTINE [[gnu::always_inline]]
#else
#define CGAL_CANONICAL_POSE_3_ROUTINE
#endif

#if defined(__GNUC__) && defined(__x86_64__)
#define CGAL_CANONICAL_POSE_3_HAS_X86_ROUTINES
#endif

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline constexpr std::size_t NUMBER_OF_LANES = 8;

// eight numbers per row
using Lane_rows = std::vector<double>;

// The unit of computation: SIZE numbers. `Bits` are unsigned integers of the same size. Addresses need not be multiples of the size; compilers may
// forget this if `Numbers` is the type of a reference, but not for `Part`.
struct Vector_of_1
{
  using Numbers = double;
  using Bits = unsigned long long;
  struct Part
  {
    Numbers numbers;
  };
  static constexpr std::size_t SIZE = 1;
};
#if defined(__GNUC__)
#define CGAL_CANONICAL_POSE_3_VECTOR(TYPE, BYTES)                                                  \
  typedef TYPE __attribute__((vector_size(BYTES), aligned(8), may_alias))
struct Vector_of_2
{
  CGAL_CANONICAL_POSE_3_VECTOR(double, 16) Numbers;
  CGAL_CANONICAL_POSE_3_VECTOR(unsigned long long, 16) Bits;
  struct [[gnu::may_alias]] Part
  {
    Numbers numbers;
  };
  static constexpr std::size_t SIZE = 2;
};
struct Vector_of_4
{
  CGAL_CANONICAL_POSE_3_VECTOR(double, 32) Numbers;
  CGAL_CANONICAL_POSE_3_VECTOR(unsigned long long, 32) Bits;
  struct [[gnu::may_alias]] Part
  {
    Numbers numbers;
  };
  static constexpr std::size_t SIZE = 4;
};
struct Vector_of_8
{
  CGAL_CANONICAL_POSE_3_VECTOR(double, 64) Numbers;
  CGAL_CANONICAL_POSE_3_VECTOR(unsigned long long, 64) Bits;
  struct [[gnu::may_alias]] Part
  {
    Numbers numbers;
  };
  static constexpr std::size_t SIZE = 8;
};
using Portable_vector = Vector_of_2;
#else
using Portable_vector = Vector_of_1;
#endif

template <class Vector>
inline constexpr std::size_t NUMBER_OF_PARTS = NUMBER_OF_LANES / Vector::SIZE;

// Part `p` of row `i`.
template <class Vector>
CGAL_CANONICAL_POSE_3_ROUTINE inline typename Vector::Part& part(double* rows, std::size_t i,
                                                                 std::size_t p)
{
  return reinterpret_cast<typename Vector::Part*>(rows + NUMBER_OF_LANES * i)[p];
}

template <class Vector>
CGAL_CANONICAL_POSE_3_ROUTINE inline const typename Vector::Part& part(const double* rows,
                                                                       std::size_t i, std::size_t p)
{
  return reinterpret_cast<const typename Vector::Part*>(rows + NUMBER_OF_LANES * i)[p];
}

// Vectors that are passed by reference must be aligned to their size.
template <class Vector>
CGAL_CANONICAL_POSE_3_ROUTINE inline void take_square_roots(typename Vector::Numbers& x)
{
  std::array<double, Vector::SIZE> numbers;
  std::memcpy(numbers.data(), &x, sizeof(x));
  for(double& number : numbers)
    number = std::sqrt(number);
  std::memcpy(&x, numbers.data(), sizeof(x));
}

// Whether x > factor * y in any lane.
template <class Vector>
CGAL_CANONICAL_POSE_3_ROUTINE inline bool is_any_above(const typename Vector::Numbers& x,
                                                       const double factor,
                                                       const typename Vector::Numbers& y)
{
  std::array<double, Vector::SIZE> left, right;
  std::memcpy(left.data(), &x, sizeof(x));
  std::memcpy(right.data(), &y, sizeof(y));
  bool result = false;
  for(std::size_t k = 0; k < Vector::SIZE; ++k)
    result |= left[k] > factor * right[k];
  return result;
}

#ifdef CGAL_CANONICAL_POSE_3_HAS_X86_ROUTINES

template <class Routine, class... Arguments>
__attribute__((target("avx512f,fma"))) void run_with_avx512(Arguments... arguments)
{
  Routine::template run<Vector_of_8>(arguments...);
}

template <class Routine, class... Arguments>
__attribute__((target("avx2,fma"))) void run_with_avx2(Arguments... arguments)
{
  Routine::template run<Vector_of_4>(arguments...);
}

#endif

template <class Routine, class... Arguments>
void run_routine(Arguments... arguments)
{
#ifdef CGAL_CANONICAL_POSE_3_HAS_X86_ROUTINES
  if(__builtin_cpu_supports("avx512f"))
    return run_with_avx512<Routine>(arguments...);
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return run_with_avx2<Routine>(arguments...);
#endif
  Routine::template run<Portable_vector>(arguments...);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_LANES_H
