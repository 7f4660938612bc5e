// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_REGISTRATION_TAUBIN_FAIRING_H
#define CANONICAL_POSE_3_ENGINE_REGISTRATION_TAUBIN_FAIRING_H

#include <CGAL/Canonical_pose_3/internal/surface/boundary_triangles.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Fairing of the boundary of a body (Taubin 1995): v <- v + step * (mean of the neighbors - v),
// with alternating steps lambda > 0 and mu < 0, so that the shape does not shrink. Interior
// vertices do not move.
class Taubin_fairing
{
public:
  Taubin_fairing(const Point_matrix& rest, const std::vector<std::array<int, 4>>& cells)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(const Index_triangle& t : boundary_triangles(rest, cells, true))
      for(int k = 0; k < 3; ++k)
        for(int other = 1; other < 3; ++other)
          entries.emplace_back(static_cast<int>(t[k]), static_cast<int>(t[(k + other) % 3]), 1.);
    m_umbrella.resize(rest.rows(), rest.rows());
    // An edge of two faces occurs twice, but counts once.
    m_umbrella.setFromTriplets(entries.begin(), entries.end(), [](double a, double) { return a; });
    for(Eigen::Index v = 0; v < m_umbrella.outerSize(); ++v)
    {
      const double degree = m_umbrella.row(v).sum();
      for(Row_major::InnerIterator it(m_umbrella, v); it; ++it)
        it.valueRef() /= degree;
    }
  }

  Point_matrix operator()(const Point_matrix& points, const int passes, const double lambda,
                          const double mu) const
  {
    Point_matrix faired = points;
    for(int pass = 0; pass < passes; ++pass)
      for(const double step : {lambda, mu})
      {
        Point_matrix mean = m_umbrella * faired;
        for(Eigen::Index v = 0; v < m_umbrella.outerSize(); ++v)
          if(Row_major::InnerIterator(m_umbrella, v))
            faired.row(v) += step * (mean.row(v) - faired.row(v)).eval();
      }
    return faired;
  }

private:
  using Row_major = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  Row_major m_umbrella;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_REGISTRATION_TAUBIN_FAIRING_H
