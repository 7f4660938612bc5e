// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_CLOSEST_ROTATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_CLOSEST_ROTATION_H

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The results of the closed form below, except for the rotation.
template <class Real>
struct Rotation_root
{
  Real root;      // the largest trace(R^t F) over the rotations R
  Real last_step; // of Newton's method
  Real slope;     // a fourth of the product of the distances to the other roots
};

// The rotation R closest to F, in closed form but for one root of a quartic. Let s be the singular
// values of F, one of them negative if the determinant is. The largest trace(R^t F) is the largest
// root of
//   p(x) = (x - s1 - s2 - s3) (x - s1 + s2 + s3) (x + s1 - s2 + s3) (x + s1 + s2 - s3)
//        = x^4 - 2 |F|^2 x^2 - 8 det(F) x + |F|^4 - 4 |cof F|^2,
// and R is its derivative with respect to F. Newton's method approaches the root from above, where
// p is convex.
template <class Real>
Rotation_root<Real> rotation_by_root(const Matrix_3<Real>& f, Matrix_3<Real>& r)
{
  using std::sqrt;
  Matrix_3<Real> cofactors, square; // square: F^t F, from the diagonal on
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
    {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactors[i][j] = f[i1][j1] * f[i2][j2] - f[i1][j2] * f[i2][j1];
      if(i <= j)
        square[i][j] = f[0][i] * f[0][j] + f[1][i] * f[1][j] + f[2][i] * f[2][j];
    }
  const Real norm = square[0][0] + square[1][1] + square[2][2];
  const Real determinant
    = f[0][0] * cofactors[0][0] + f[0][1] * cofactors[0][1] + f[0][2] * cofactors[0][2];
  Real cofactor_norm = cofactors[0][0] * cofactors[0][0];
  for(int k = 1; k < 9; ++k)
    cofactor_norm = cofactor_norm + cofactors[k / 3][k % 3] * cofactors[k / 3][k % 3];
  const Real constant = norm * norm - 4 * cofactor_norm;

  Rotation_root<Real> result;
  Real& x = result.root;
  x = sqrt(norm + 3.4641016151377546 * sqrt(cofactor_norm)); // 2 sqrt(3): not below the root
  const auto is_moving = [&] {
    if constexpr(std::is_arithmetic<Real>::value)
      return result.last_step > 1e-8 * x;
    else
      return (result.last_step - 1e-8 * x).maxCoeff() > 0;
  };
  int iterations = 0;
  do
  {
    const Real a = x * x - norm;
    result.last_step
      = (((a - norm) * x - 8 * determinant) * x + constant) / (4 * (a * x - 2 * determinant));
    x = x - result.last_step;
  } while(is_moving() && ++iterations < 16);
  result.slope = (x * x - norm) * x - 2 * determinant;

  const Real scale = 1 / result.slope;
  const Real first = (x * x + norm) * scale, second = 2 * x * scale, third = 2 * scale;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
    {
      const Real cube = f[i][0] * square[0][j]
                        + f[i][1] * square[(std::min)(1, j)][(std::max)(1, j)]
                        + f[i][2] * square[j][2];
      r[i][j] = first * f[i][j] + second * cofactors[i][j] - third * cube;
    }
  return result;
}

// Whether the rotation is accurate to 1e-12. It is not if the root is nearly a double root (s2 + s3
// is small), or if powers of it underflow or overflow. In these cases, a step may even increase x,
// and by a lot.
inline bool is_reliable(const double root, const double last_step, const double slope)
{
  return slope > 0.03 * root * root * root && std::abs(last_step) <= 1e-8 * root && root > 1e-70;
}

// Returns the rotation R (determinant +1) closest to m in the Frobenius norm: in closed form, or by
// a singular value decomposition if that is not reliable. Returns an arbitrary rotation if m is not
// finite.
inline Eigen::Matrix3d closest_rotation(const Eigen::Matrix3d& m)
{
  if(!m.allFinite())
    return Eigen::Matrix3d::Identity();
  Matrix_3<double> f, r;
  for(int k = 0; k < 9; ++k)
    f[k / 3][k % 3] = m(k / 3, k % 3);
  const Rotation_root<double> q = rotation_by_root(f, r);
  if(!is_reliable(q.root, q.last_step, q.slope))
    return rotation_by_traits<Deformation_Eigen_closest_rotation_traits_3>(m);
  Eigen::Matrix3d result;
  for(int k = 0; k < 9; ++k)
    result(k / 3, k % 3) = r[k / 3][k % 3];
  return result;
}

// The same for eight matrices.
inline void closest_rotations(const Matrix_3<Pack>& f, Matrix_3<Pack>& r)
{
  const Rotation_root<Pack> q = rotation_by_root(f, r);
  for(int lane = 0; lane < pack_size; ++lane)
    if(!is_reliable(q.root[lane], q.last_step[lane], q.slope[lane]))
      for_lane(f, r, lane, closest_rotation);
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_ENERGY_CLOSEST_ROTATION_H
