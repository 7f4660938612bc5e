// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_ENERGY_CLOSEST_ROTATION_H
#define CANONICAL_POSE_3_ENGINE_ENERGY_CLOSEST_ROTATION_H

#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The results of the closed form below, except for the rotation.
template <class Vector>
struct alignas(sizeof(typename Vector::Numbers)) Rotation_root
{
  using Numbers = typename Vector::Numbers;

  Numbers root;      // the largest trace(R^t F) over the rotations R
  Numbers last_step; // of Newton's method
  Numbers slope;     // a fourth of the product of the distances to the other roots
};

// The rotation R closest to F, in closed form but for one root of a quartic. Let s be the singular
// values of F, one of them negative if the determinant is. The largest trace(R^t F) is the largest
// root of
//   p(x) = (x - s1 - s2 - s3) (x - s1 + s2 + s3) (x + s1 - s2 + s3) (x + s1 + s2 - s3)
//        = x^4 - 2 |F|^2 x^2 - 8 det(F) x + |F|^4 - 4 |cof F|^2,
// and R is its derivative with respect to F. Newton's method approaches the root from above, where
// p is convex.
template <class Vector>
CGAL_CANONICAL_POSE_3_ROUTINE inline void
rotation_by_root(const Matrix_3<Vector>& f, Matrix_3<Vector>& r, Rotation_root<Vector>& result)
{
  using Numbers = typename Vector::Numbers;
  Matrix_3<Vector> cofactors, square; // square: F^t F, from the diagonal on
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
    {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactors.entries[i][j]
        = f.entries[i1][j1] * f.entries[i2][j2] - f.entries[i1][j2] * f.entries[i2][j1];
      if(i <= j)
        square.entries[i][j] = f.entries[0][i] * f.entries[0][j] + f.entries[1][i] * f.entries[1][j]
                               + f.entries[2][i] * f.entries[2][j];
    }
  const Numbers norm = square.entries[0][0] + square.entries[1][1] + square.entries[2][2];
  const Numbers determinant = f.entries[0][0] * cofactors.entries[0][0]
                              + f.entries[0][1] * cofactors.entries[0][1]
                              + f.entries[0][2] * cofactors.entries[0][2];
  Numbers cofactor_norm = cofactors.entries[0][0] * cofactors.entries[0][0];
  for(int k = 1; k < 9; ++k)
    cofactor_norm += cofactors.entries[k / 3][k % 3] * cofactors.entries[k / 3][k % 3];
  const Numbers constant = norm * norm - 4 * cofactor_norm;

  Numbers& x = result.root;
  x = cofactor_norm;
  take_square_roots<Vector>(x);
  x = norm + 3.4641016151377546 * x; // 2 sqrt(3)
  take_square_roots<Vector>(x);      // not below the root
  int iterations = 0;
  do
  {
    const Numbers a = x * x - norm;
    result.last_step
      = (((a - norm) * x - 8 * determinant) * x + constant) / (4 * (a * x - 2 * determinant));
    x -= result.last_step;
  } while(is_any_above<Vector>(result.last_step, 1e-8, x) && ++iterations < 16);
  result.slope = (x * x - norm) * x - 2 * determinant;

  const Numbers scale = 1 / result.slope;
  const Numbers first = (x * x + norm) * scale, second = 2 * x * scale, third = 2 * scale;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
    {
      const Numbers cube = f.entries[i][0] * square.entries[0][j]
                           + f.entries[i][1] * square.entries[j < 1 ? j : 1][j < 1 ? 1 : j]
                           + f.entries[i][2] * square.entries[j][2];
      r.entries[i][j] = first * f.entries[i][j] + second * cofactors.entries[i][j] - third * cube;
    }
}

// The same for eight matrices. `roots`: three rows.
struct Rotations_by_roots
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const double* f, double* r, double* roots)
  {
    for(std::size_t p = 0; p < NUMBER_OF_PARTS<Vector>; ++p)
    {
      Matrix_3<Vector> matrices, rotations;
      load_matrices<Vector>(f, p, matrices);
      Rotation_root<Vector> result;
      rotation_by_root<Vector>(matrices, rotations, result);
      for(std::size_t k = 0; k < 9; ++k)
        part<Vector>(r, k, p).numbers = rotations.entries[k / 3][k % 3];
      part<Vector>(roots, 0, p).numbers = result.root;
      part<Vector>(roots, 1, p).numbers = result.last_step;
      part<Vector>(roots, 2, p).numbers = result.slope;
    }
  }
};

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
  Matrix_3<Vector_of_1> f, r;
  for(int k = 0; k < 9; ++k)
    f.entries[k / 3][k % 3] = m(k / 3, k % 3);
  Rotation_root<Vector_of_1> q;
  rotation_by_root<Vector_of_1>(f, r, q);
  if(!is_reliable(q.root, q.last_step, q.slope))
    return rotation_by_traits<Deformation_Eigen_closest_rotation_traits_3>(m);
  Eigen::Matrix3d result;
  for(int k = 0; k < 9; ++k)
    result(k / 3, k % 3) = r.entries[k / 3][k % 3];
  return result;
}

// The same for eight matrices.
inline void closest_rotations(const Lane_matrix& f, Lane_matrix& r)
{
  std::array<double, 3 * NUMBER_OF_LANES> roots;
  run_routine<Rotations_by_roots>(f.data(), r.data(), roots.data());
  for(std::size_t lane = 0; lane < NUMBER_OF_LANES; ++lane)
    if(!is_reliable(roots[lane], roots[NUMBER_OF_LANES + lane], roots[2 * NUMBER_OF_LANES + lane]))
      set_matrix_of_lane(r, lane, closest_rotation(matrix_of_lane(f, lane)));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_ENERGY_CLOSEST_ROTATION_H
