// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_SURFACE_ARAP_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_SURFACE_ARAP_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

#include "Sparse_system.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace Canonical_pose_benchmark {

/// The as-rigid-as-possible energy of a surface without a body (Sorkine and Alexa 2007), in the place
/// of that of the tetrahedra: a rotation per vertex, cotangent weights (those below 0 are set to 0).
///   sum_i m_i |v_i - target_i|^2 / L^2 + l^2 / (2 A) sum_ij c_ij |(v_i - v_j) - R_i (r_i - r_j)|^2,
/// A being the area, so that l means what it means for the tetrahedra: the second term is the mean
/// over the surface of |F - R|^2 times l^2.
class Surface_arap
{
public:
  using Point_matrix = CGAL::Canonical_pose_3::Point_matrix;
  using Triangles = std::vector<std::array<std::size_t, 3>>;

  /// `shares`: m, with sum 1.
  Surface_arap(const Point_matrix& rest, const Triangles& triangles, const Eigen::VectorXd& shares,
               const double length_scale, const double detail_length)
    : m_length_scale(length_scale), m_rest(rest / length_scale), m_shares(shares)
  {
    std::vector<Eigen::Triplet<double>> entries;
    double area = 0;
    for(const auto& t : triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto p = static_cast<int>(t[(k + 1) % 3]), q = static_cast<int>(t[(k + 2) % 3]);
        const Eigen::Vector3d e = m_rest.row(p) - m_rest.row(static_cast<Eigen::Index>(t[k]));
        const Eigen::Vector3d f = m_rest.row(q) - m_rest.row(static_cast<Eigen::Index>(t[k]));
        const double twice_area = e.cross(f).norm();
        area += twice_area / 6;
        if(twice_area > 0)
          for(const auto& [i, j] : {std::array{p, q}, std::array{q, p}})
            entries.emplace_back(i, j, e.dot(f) / twice_area / 2);
      }
    m_cotangents.resize(rest.rows(), rest.rows());
    m_cotangents.setFromTriplets(entries.begin(), entries.end());
    m_cotangents.coeffs() = detail_length * detail_length / area * m_cotangents.coeffs().max(0);

    Eigen::SparseMatrix<double> matrix = -m_cotangents;
    const Eigen::VectorXd sums = m_cotangents * Eigen::VectorXd::Ones(rest.rows());
    matrix += Eigen::SparseMatrix<double>((sums + shares).asDiagonal());
    m_system = std::make_unique<Sparse_system>(matrix);
  }

  /// Local and global steps in turn from the target on, until the energy decreases by less than a
  /// relative 1e-6.
  Point_matrix run(const Point_matrix& target)
  {
    Point_matrix v = target / m_length_scale;
    const Point_matrix target_term = m_shares.asDiagonal() * v;
    double previous = 0;
    for(int iteration = 0; iteration < 2000; ++iteration)
    {
      const double energy
        = fit_rotations(v)
          + (v - target / m_length_scale).rowwise().squaredNorm().cwiseProduct(m_shares).sum();
      if(iteration > 0 && previous - energy <= 1e-6 * previous)
        break;
      previous = energy;
      v = m_system->solve(target_term + rotated_edges());
    }
    return m_length_scale * v;
  }

private:
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;

  // Returns the energy of the edges.
  double fit_rotations(const Point_matrix& v)
  {
    CGAL::Deformation_Eigen_closest_rotation_traits_3 traits;
    m_rotations.resize(static_cast<std::size_t>(v.rows()));
    double energy = 0;
    for(Eigen::Index i = 0; i < v.rows(); ++i)
    {
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      for(Entry it(m_cotangents, i); it; ++it)
        covariance += it.value() * (m_rest.row(i) - m_rest.row(it.row())).transpose()
                      * (v.row(i) - v.row(it.row()));
      Eigen::Matrix3d& rotation = m_rotations[static_cast<std::size_t>(i)];
      traits.compute_close_rotation(covariance, rotation);
      for(Entry it(m_cotangents, i); it; ++it)
        energy += it.value() / 2
                  * ((v.row(i) - v.row(it.row())).transpose()
                     - rotation * (m_rest.row(i) - m_rest.row(it.row())).transpose())
                      .squaredNorm();
    }
    return energy;
  }

  Point_matrix rotated_edges() const
  {
    Point_matrix sum = Point_matrix::Zero(m_rest.rows(), 3);
    for(Eigen::Index i = 0; i < m_rest.rows(); ++i)
      for(Entry it(m_cotangents, i); it; ++it)
        sum.row(i) += it.value() / 2
                      * ((m_rotations[static_cast<std::size_t>(i)]
                          + m_rotations[static_cast<std::size_t>(it.row())])
                         * (m_rest.row(i) - m_rest.row(it.row())).transpose())
                          .transpose();
    return sum;
  }

  double m_length_scale;
  Point_matrix m_rest;
  Eigen::VectorXd m_shares;
  Eigen::SparseMatrix<double> m_cotangents; // times l^2 / A
  std::unique_ptr<Sparse_system> m_system;
  std::vector<Eigen::Matrix3d> m_rotations; // of the vertices
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_SURFACE_ARAP_H
