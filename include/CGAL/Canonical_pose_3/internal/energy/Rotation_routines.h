// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_ROTATION_ROUTINES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_ROTATION_ROUTINES_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>
#include <CGAL/Canonical_pose_3/internal/support/rotation_by_traits.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// `m.entries[row][column]`, with a vector of numbers per entry. Aligned, since compilers expect this
// of a reference to `Numbers`.
template <class Vector>
struct alignas(sizeof(typename Vector::Numbers)) Matrix_3
{
  typename Vector::Numbers entries[3][3];
};

// Eight matrices, one per lane; row 3 i + j of the lanes are their entries (i, j).
using Lane_matrix = std::array<double, 9 * NUMBER_OF_LANES>;

// Reads part `p` of eight matrices.
template <class Vector>
CGAL_CANONICAL_POSE_3_ROUTINE inline void load_matrices(const double* matrices, const std::size_t p,
                                                        Matrix_3<Vector>& m)
{
  for(std::size_t k = 0; k < 9; ++k)
    m.entries[k / 3][k % 3] = part<Vector>(matrices, k, p).numbers;
}

inline Eigen::Matrix3d matrix_of_lane(const Lane_matrix& matrices, const std::size_t lane)
{
  using Strides = Eigen::Stride<NUMBER_OF_LANES, 3 * NUMBER_OF_LANES>;
  return Eigen::Map<const Eigen::Matrix3d, 0, Strides>(matrices.data() + lane);
}

inline void set_matrix_of_lane(Lane_matrix& matrices, const std::size_t lane,
                               const Eigen::Matrix3d& m)
{
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      matrices[NUMBER_OF_LANES * static_cast<std::size_t>(3 * i + j) + lane] = m(i, j);
}

template <class ClosestRotationTraits>
void rotations_by_traits(const Lane_matrix& f, Lane_matrix& r)
{
  for(std::size_t lane = 0; lane < NUMBER_OF_LANES; ++lane)
    set_matrix_of_lane(r, lane, rotation_by_traits<ClosestRotationTraits>(matrix_of_lane(f, lane)));
}

struct Rotation_routines
{
  Eigen::Matrix3d (*one)(const Eigen::Matrix3d&);
  void (*eight)(const Lane_matrix&, Lane_matrix&);
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_ROTATION_ROUTINES_H
