// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Stress_weights.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Smacof_target_builder_3.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/internal/target/check_landmark_fields.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// The share of the points nearest to each landmark in the weights, at least 1e-4.
inline Eigen::VectorXd landmark_shares(const Landmark_fields_3& fields,
                                       const Eigen::VectorXd& weights)
{
  constexpr double least = 1e-4;
  const Eigen::Index n = fields.distances.rows();
  Eigen::VectorXd nearest = fields.distances.col(0);
  Eigen::VectorXi landmark = Eigen::VectorXi::Zero(n);
  for(Eigen::Index j = 1; j < fields.distances.cols(); ++j)
    for(Eigen::Index i = 0; i < n; ++i)
      if(fields.distances(i, j) < nearest[i])
      {
        nearest[i] = fields.distances(i, j);
        landmark[i] = static_cast<int>(j);
      }
  Eigen::VectorXd result = Eigen::VectorXd::Zero(fields.distances.cols());
  for(Eigen::Index i = 0; i < n; ++i)
    result[landmark[i]] += weights[i];
  return (result / result.sum()).cwiseMax(least);
}

// Positions of landmarks for their symmetric distances, by majorization of the weighted stress.
class Landmark_majorization
{
public:
  Landmark_majorization(Eigen::MatrixXd distances, const Eigen::VectorXd& shares,
                        const Stress_weights& weights, Point_matrix start)
    : m_distances(std::move(distances)), m_stress_weights(weights), m_points(std::move(start))
  {
    const Eigen::Index l = shares.size();
    m_base_weights = Eigen::MatrixXd::Zero(l, l);
    for(Eigen::Index j = 0; j < l; ++j)
      for(Eigen::Index i = 0; i < l; ++i)
        if(i != j)
          m_base_weights(i, j)
            = shares[i] * shares[j] * m_stress_weights.of_distance(m_distances(i, j));
    m_weights = m_base_weights;
    factor();
    measure();
    minimize();
  }

  const Point_matrix& points() const { return m_points; }
  double stress() const { return std::sqrt(m_squared_stress); }
  int iterations() const { return m_iterations; }

private:
  static constexpr int MOST_ITERATIONS = 1000;
  static constexpr double TOLERANCE = 1e-6;

  void minimize()
  {
    double previous = (std::numeric_limits<double>::infinity)();
    while(m_iterations < MOST_ITERATIONS && m_squared_stress < (1 - TOLERANCE) * previous)
    {
      previous = m_squared_stress;
      m_points = m_factor.solve(m_guttman * m_points);
      ++m_iterations;
      if(m_stress_weights.are_robust())
        weigh_residuals();
      measure();
    }
  }

  void weigh_residuals()
  {
    for(Eigen::Index j = 0; j < m_weights.cols(); ++j)
      for(Eigen::Index i = 0; i < j; ++i)
        m_weights(i, j) = m_weights(j, i)
          = m_base_weights(i, j)
            * m_stress_weights.of_residual((m_points.row(i) - m_points.row(j)).norm()
                                           - m_distances(i, j));
    factor();
  }

  // The Laplacian of the weights, which is singular for translations: these are fixed by a term
  // that keeps the centroid at the origin, where the other side has it.
  void factor()
  {
    Eigen::MatrixXd laplacian = -m_weights;
    laplacian.diagonal() = m_weights.rowwise().sum();
    const auto l = static_cast<double>(m_weights.rows());
    laplacian.array() += laplacian.trace() / (l * l);
    m_factor.compute(laplacian);
  }

  // The relative squared stress, and the matrix B of the Guttman transform.
  void measure()
  {
    const Eigen::Index l = m_points.rows();
    m_guttman = Eigen::MatrixXd::Zero(l, l);
    double residuals = 0, squares = 0;
    for(Eigen::Index j = 0; j < l; ++j)
      for(Eigen::Index i = 0; i < j; ++i)
      {
        const double d = (m_points.row(i) - m_points.row(j)).norm(), g = m_distances(i, j);
        residuals += m_base_weights(i, j) * m_stress_weights.loss(d - g);
        squares += m_base_weights(i, j) * g * g;
        const double b = d > 0 ? m_weights(i, j) * g / d : 0;
        m_guttman(i, j) = m_guttman(j, i) = -b;
        m_guttman(i, i) += b;
        m_guttman(j, j) += b;
      }
    m_squared_stress = squares > 0 ? residuals / squares : 0;
  }

  Eigen::MatrixXd m_distances, m_base_weights, m_weights, m_guttman;
  const Stress_weights m_stress_weights;
  Point_matrix m_points;
  Eigen::LDLT<Eigen::MatrixXd> m_factor;
  double m_squared_stress = 0;
  int m_iterations = 0;
};

// Finds the position of a point from its distances to the landmarks.
class Point_multilateration
{
public:
  Point_multilateration(const Point_matrix& landmarks, const Point_matrix& displacements,
                        const Eigen::VectorXd& shares, const Stress_weights& weights)
    : m_landmarks(landmarks), m_displacements(displacements), m_shares(shares),
      m_stress_weights(weights), m_distances(shares.size()), m_weights(shares.size())
  {}

  // Returns the position; `stress` receives the relative residual. In units of the largest
  // distance.
  Eigen::RowVector3d operator()(const Eigen::VectorXd& distances, const Eigen::RowVector3d& start,
                                double& stress)
  {
    m_distances = distances;
    Eigen::RowVector3d move = Eigen::RowVector3d::Zero();
    double sum = 0, squares = 0;
    for(Eigen::Index j = 0; j < m_distances.size(); ++j)
    {
      const double d = m_distances[j], nearness = 1 / ((d + 1e-3) * (d + 1e-3));
      move += nearness * nearness * m_displacements.row(j);
      sum += nearness * nearness;
      m_weights[j] = m_shares[j] * m_stress_weights.of_distance(d);
      squares += m_weights[j] * d * d;
    }
    Eigen::Vector3d x = (start + move / sum).transpose();
    double energy = descend(x);
    stress = squares > 0 ? std::sqrt(energy / squares) : 0;
    return x.transpose();
  }

private:
  static constexpr int MOST_ITERATIONS = 20;
  static constexpr double TOLERANCE = 1e-4;

  // The energy at x, and half its gradient and Gauss-Newton Hessian.
  double energy(const Eigen::Vector3d& x, Eigen::Matrix3d& hessian, Eigen::Vector3d& gradient) const
  {
    double result = 0;
    double h00 = 0, h01 = 0, h02 = 0, h11 = 0, h12 = 0, h22 = 0, g0 = 0, g1 = 0, g2 = 0;
    for(Eigen::Index j = 0; j < m_distances.size(); ++j)
    {
      double r0 = x[0] - m_landmarks(j, 0), r1 = x[1] - m_landmarks(j, 1),
             r2 = x[2] - m_landmarks(j, 2);
      const double length = std::sqrt(r0 * r0 + r1 * r1 + r2 * r2);
      const double residual = length - m_distances[j];
      result += m_weights[j] * m_stress_weights.loss(residual);
      if(!(length > 0))
        continue;
      const double w = m_weights[j] * m_stress_weights.of_residual(residual);
      r0 /= length;
      r1 /= length;
      r2 /= length;
      const double force = w * residual;
      g0 += force * r0;
      g1 += force * r1;
      g2 += force * r2;
      h00 += w * r0 * r0;
      h01 += w * r0 * r1;
      h02 += w * r0 * r2;
      h11 += w * r1 * r1;
      h12 += w * r1 * r2;
      h22 += w * r2 * r2;
    }
    hessian << h00, h01, h02, h01, h11, h12, h02, h12, h22;
    gradient << g0, g1, g2;
    return result;
  }

  double descend(Eigen::Vector3d& x) const
  {
    Eigen::Matrix3d hessian;
    Eigen::Vector3d gradient;
    double current = energy(x, hessian, gradient), damping = 1e-3;
    for(int k = 0; k < MOST_ITERATIONS && hessian.trace() > 0; ++k)
    {
      Eigen::Matrix3d damped = hessian;
      damped.diagonal().array() += damping * hessian.trace() / 3;
      const Eigen::Vector3d next = x - damped.llt().solve(gradient);
      Eigen::Matrix3d next_hessian;
      Eigen::Vector3d next_gradient;
      const double value = energy(next, next_hessian, next_gradient);
      if(!(value < current))
      {
        if(damping > 1e3)
          break;
        damping *= 10;
        continue;
      }
      const bool is_small = current - value <= TOLERANCE * current;
      x = next;
      current = value;
      hessian = next_hessian;
      gradient = next_gradient;
      damping *= 0.1;
      if(is_small)
        break;
    }
    return current;
  }

  const Point_matrix &m_landmarks, &m_displacements;
  const Eigen::VectorXd& m_shares;
  const Stress_weights m_stress_weights;
  Eigen::VectorXd m_distances, m_weights;
};

} // namespace internal

Smacof_target_builder_3::Smacof_target_builder_3(const double weight_exponent,
                                                 const double robust_scale)
  : m_weight_exponent(weight_exponent), m_robust_scale(robust_scale)
{
  internal::require_in_range("weight_exponent", weight_exponent, -5, 5);
  internal::require_in_range("robust_scale", robust_scale, 1e-3, 1e3, true);
}

void Smacof_target_builder_3::build(const Landmark_fields_3& fields, const Point_matrix& start,
                                    const Eigen::VectorXd& weights)
{
  const Eigen::Index n = fields.distances.rows(), l = fields.distances.cols();
  internal::check_landmark_fields(fields, static_cast<std::size_t>(n), "the landmark fields");
  CANONICAL_POSE_3_PRECONDITION(start.rows() == n && start.allFinite());
  CANONICAL_POSE_3_PRECONDITION(weights.size() == n && weights.sum() > 0);
  m_length_scale = fields.distances.maxCoeff();
  const double unit = m_length_scale > 0 ? m_length_scale : 1;
  const internal::Stress_weights stress_weights(m_weight_exponent, m_robust_scale);
  const Eigen::VectorXd shares = internal::landmark_shares(fields, weights);
  Eigen::MatrixXd g(l, l);
  Point_matrix landmarks(l, 3);
  for(Eigen::Index j = 0; j < l; ++j)
  {
    const auto row = static_cast<Eigen::Index>(fields.landmarks[static_cast<std::size_t>(j)]);
    g.row(j) = fields.distances.row(row) / unit;
    landmarks.row(j) = start.row(row) / unit;
  }
  const Eigen::RowVector3d center = landmarks.colwise().mean();
  landmarks.rowwise() -= center;
  const internal::Landmark_majorization majorization(0.5 * (g + g.transpose()), shares,
                                                     stress_weights, landmarks);
  m_stress = majorization.stress();
  m_iterations = majorization.iterations();
  const Point_matrix displacements = majorization.points() - landmarks;
  m_targets.resize(n, 3);
  m_point_stress.resize(n);
  internal::for_each_block(
    static_cast<std::size_t>(n), [&](std::size_t, const std::size_t begin, const std::size_t end) {
      internal::Point_multilateration locate(majorization.points(), displacements, shares,
                                             stress_weights);
      for(auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
        m_targets.row(i) = locate(fields.distances.row(i).transpose() / unit,
                                  start.row(i) / unit - center, m_point_stress[i]);
    });
  m_targets = (m_targets.rowwise() + center) * unit;
  m_landmark_targets = (majorization.points().rowwise() + center) * unit;
}

} // namespace Canonical_pose_3
} // namespace CGAL
