// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_ROTATION_ROUTINES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_ROTATION_ROUTINES_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/rotation_by_traits.h>

#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Eight numbers that are processed at once.
using Pack = Eigen::Array<double, 8, 1>;
constexpr int pack_size = 8;

// `m[row][column]`; with packs, eight matrices.
template <class Real>
using Matrix_3 = std::array<std::array<Real, 3>, 3>;

// Applies a function of a matrix to one of eight matrices.
template <class Function>
void for_lane(const Matrix_3<Pack>& f, Matrix_3<Pack>& r, const int lane, const Function& function)
{
  Eigen::Matrix3d m;
  for(int k = 0; k < 9; ++k)
    m(k / 3, k % 3) = f[k / 3][k % 3][lane];
  m = function(m);
  for(int k = 0; k < 9; ++k)
    r[k / 3][k % 3][lane] = m(k / 3, k % 3);
}

template <class ClosestRotationTraits>
void rotations_by_traits(const Matrix_3<Pack>& f, Matrix_3<Pack>& r)
{
  for(int lane = 0; lane < pack_size; ++lane)
    for_lane(f, r, lane, rotation_by_traits<ClosestRotationTraits>);
}

// The routines that compute the closest rotations, chosen at run time.
struct Rotation_routines
{
  Eigen::Matrix3d (*one)(const Eigen::Matrix3d&);
  void (*eight)(const Matrix_3<Pack>&, Matrix_3<Pack>&);
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_ROTATION_ROUTINES_H
