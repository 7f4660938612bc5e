// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_ENERGY_ELASTIC_CELL_H
#define CANONICAL_POSE_3_ENGINE_ENERGY_ELASTIC_CELL_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include <array>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Vector_9 = Eigen::Matrix<double, 9, 1>;
using Matrix_9 = Eigen::Matrix<double, 9, 9>;

// The derivative of the determinant of f with respect to f.
inline Eigen::Matrix3d cofactors(const Eigen::Matrix3d& f)
{
  Eigen::Matrix3d result;
  result << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
  return result;
}

// The second derivative, with f stored column by column.
inline Matrix_9 determinant_hessian(const Eigen::Matrix3d& f)
{
  Matrix_9 result = Matrix_9::Zero();
  for(int j = 0; j < 3; ++j) // the determinant is f_j . (f_k x f_l)
  {
    const int k = (j + 1) % 3, l = (j + 2) % 3;
    Eigen::Matrix3d cross; // times y: f_l x y
    cross << 0, -f(2, l), f(1, l), f(2, l), 0, -f(0, l), -f(1, l), f(0, l), 0;
    result.block<3, 3>(3 * j, 3 * k) -= cross;
    result.block<3, 3>(3 * k, 3 * j) += cross;
  }
  return result;
}

// A cell of an elastic body.
struct Elastic_cell
{
  Eigen::Matrix<double, 4, 3> gradients; // row k: of the barycentric coordinate of vertex k
  double weight;
  std::array<int, 4> vertices;

  // The deformation gradient F.
  Eigen::Matrix3d deformation(const Point_matrix& points) const
  {
    Eigen::Matrix3d edges; // columns: the edges from vertex 3
    for(int k = 0; k < 3; ++k)
      edges.col(k) = points.row(vertices[k]) - points.row(vertices[3]);
    return edges * gradients.topRows<3>();
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_ENERGY_ELASTIC_CELL_H
