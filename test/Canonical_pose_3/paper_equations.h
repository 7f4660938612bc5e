// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_PAPER_EQUATIONS_H
#define CGAL_CANONICAL_POSE_3_TEST_PAPER_EQUATIONS_H

// The registration of the paper, implemented from its formulas alone: dense, in 3n unknowns,
// without any code of the package. G_t is 9 x 3n, L = sum lambda_t G_t^t G_t with lambda_t the
// volume of a cell, K stacks lambda_t G_t, rotations come from a singular value decomposition,
// springs enter by L_s and J d.

#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>

#include "matchers.h"
#include "shapes.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace Canonical_pose_test {

using Spring = std::optional<CGAL::Canonical_pose_3::Spring_3>;

constexpr double PAPER_ALPHA = 100, PAPER_BETA = 10;

inline Eigen::VectorXd stacked(const Point_matrix& points)
{
  const Eigen::Matrix3Xd columns = points.transpose();
  return Eigen::Map<const Eigen::VectorXd>(columns.data(), columns.size());
}

/// The iteration of Sections 6 and 7. Where the paper leaves a choice: the pose before the first
/// iteration is the target; fairing is Taubin's with uniform weights over the edges of the
/// boundary, one step of 0.5 and one of -0.53, and does not move interior vertices.
class Paper_equations
{
public:
  Paper_equations(const Tetrahedral_soup& body, const Point_matrix& target, const Spring& spring)
    : n(Eigen::Index(body.points.size())), v_hat(stacked(target)), v(v_hat),
      L(Eigen::MatrixXd::Zero(3 * n, 3 * n)), s(spring)
  {
    const Point_matrix rest = to_matrix(body.points);
    for(const auto& c : body.cells)
    {
      Eigen::Matrix3d edges;
      for(int k = 0; k < 3; ++k)
        edges.col(k) = rest.row(c[k]) - rest.row(c[3]);
      const Eigen::Matrix3d inverse = edges.inverse();
      G.push_back(Eigen::MatrixXd::Zero(9, 3 * n));
      for(int column = 0; column < 3; ++column)
        for(int row = 0; row < 3; ++row)
          for(int k = 0; k < 3; ++k)
          {
            G.back()(3 * column + row, 3 * c[k] + row) += inverse(k, column);
            G.back()(3 * column + row, 3 * c[3] + row) -= inverse(k, column);
          }
      volume.push_back(std::abs(edges.determinant()) / 6);
      L += volume.back() * G.back().transpose() * G.back();
    }
    std::vector<std::size_t> origin;
    for(const auto& t : boundary(body, &origin).triangles)
      for(int k = 0; k < 3; ++k)
      {
        neighbors[origin[t[k]]].insert(origin[t[(k + 1) % 3]]);
        neighbors[origin[t[k]]].insert(origin[t[(k + 2) % 3]]);
      }
  }

  // Equation 16, which without a spring is twice Equation 13.
  Point_matrix iterate()
  {
    const Eigen::VectorXd from = first ? v_hat : faired();
    first = false;
    Eigen::VectorXd rK = Eigen::VectorXd::Zero(3 * n);
    for(std::size_t t = 0; t < G.size(); ++t)
    {
      const Eigen::VectorXd f = G[t] * from;
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Map<const Eigen::Matrix3d>(f.data()),
                                                  Eigen::ComputeFullU | Eigen::ComputeFullV);
      Eigen::Matrix3d u = svd.matrixU();
      if((u * svd.matrixV().transpose()).determinant() < 0)
        u.col(2) *= -1;
      const Eigen::Matrix3d r = u * svd.matrixV().transpose();
      rK += volume[t] * G[t].transpose() * Eigen::Map<const Eigen::VectorXd>(r.data(), 9);
    }
    Eigen::MatrixXd matrix
      = 2 * PAPER_ALPHA * L + (2 * PAPER_BETA + 2) * Eigen::MatrixXd::Identity(3 * n, 3 * n);
    Eigen::VectorXd right = 2 * v_hat + 2 * PAPER_ALPHA * rK + 2 * PAPER_BETA * v;
    if(s)
    {
      Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * n, 3); // A_s, times the identity of space
      a.middleRows<3>(3 * s->p).setIdentity();
      a.middleRows<3>(3 * s->q) = -Eigen::Matrix3d::Identity();
      const Eigen::Vector3d d = s->rest_length * (a.transpose() * v).normalized();
      matrix += s->stiffness * a * a.transpose(); // L_s
      right += s->stiffness * a * d;              // J d
    }
    v = matrix.ldlt().solve(right);
    return Eigen::Map<const Eigen::Matrix3Xd>(v.data(), 3, n).transpose();
  }

private:
  Eigen::VectorXd faired() const
  {
    Eigen::VectorXd result = v;
    for(const double step : {0.5, -0.53})
    {
      const Eigen::VectorXd before = result;
      for(const auto& [i, others] : neighbors)
        for(const std::size_t j : others)
          result.segment<3>(3 * i)
            += step / double(others.size()) * (before.segment<3>(3 * j) - before.segment<3>(3 * i));
    }
    return result;
  }

  Eigen::Index n;
  Eigen::VectorXd v_hat, v;
  Eigen::MatrixXd L;
  Spring s;
  std::vector<Eigen::MatrixXd> G;
  std::vector<double> volume;
  std::map<std::size_t, std::set<std::size_t>> neighbors;
  bool first = true;
};

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_PAPER_EQUATIONS_H
