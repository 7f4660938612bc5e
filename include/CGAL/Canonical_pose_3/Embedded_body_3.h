// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EMBEDDED_BODY_3_H
#define CGAL_CANONICAL_POSE_3_EMBEDDED_BODY_3_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an elastic body in which a surface is embedded by an arbitrary matrix.

\cgalModels `ElasticBody_3`

\sa `Conforming_body_3`
\sa `mesh_3_body()`
\sa `Tetrahedral_arap_registrar_3`
*/
class Embedded_body_3
{
public:
  /*!
  constructs the body.

  \param points \f$ N \times 3 \f$, rest positions of the body vertices.
  \param cells four rows of `points` per cell, in either orientation.
  \param embedding \f$ n \times N \f$, one row per surface vertex, with sum 1.

  \throws std::invalid_argument if there is no cell, a cell has an invalid or repeated row, a
         coordinate is not finite, a cell has no volume, the embedding has the wrong number of
         columns, or a row of it does not sum to 1; the message states the index of the element.

  <em>Complexity:</em> linear.
  */
  Embedded_body_3(Point_matrix points, std::vector<std::array<int, 4>> cells,
                  Eigen::SparseMatrix<double> embedding)
    : m_points(std::move(points)), m_cells(std::move(cells)), m_embedding(std::move(embedding))
  {
    if(m_cells.empty())
      throw std::invalid_argument("the body has no cell");
    internal::check_finite(m_points);
    check_embedding();
    measure_cells();
  }

  /// returns the \f$ N \times 3 \f$ rest positions.
  const Point_matrix& points() const { return m_points; }

  /// returns the cells, four rows of `points()` each.
  const std::vector<std::array<int, 4>>& cells() const { return m_cells; }

  /// returns the share of each cell in the rest volume; the sum is 1.
  const Eigen::VectorXd& cell_weights() const { return m_cell_weights; }

  /// returns the rest volume.
  double volume() const { return m_volume; }

  /// returns the \f$ n \times N \f$ matrix \f$ B \f$.
  const Eigen::SparseMatrix<double>& embedding() const { return m_embedding; }

private:
  void check_embedding() const
  {
    if(m_embedding.cols() != m_points.rows())
      throw std::invalid_argument("the embedding has " + std::to_string(m_embedding.cols())
                                  + " columns, but there are " + std::to_string(m_points.rows())
                                  + " body vertices");
    const Eigen::VectorXd sums = m_embedding * Eigen::VectorXd::Ones(m_points.rows());
    for(Eigen::Index i = 0; i < sums.size(); ++i)
      if(!(std::abs(sums[i] - 1) <= 1e-9))
        throw std::invalid_argument("row " + std::to_string(i) + " of the embedding has the sum "
                                    + std::to_string(sums[i]) + ", but it must be 1");
  }

  void measure_cells()
  {
    const double size = (m_points.colwise().maxCoeff() - m_points.colwise().minCoeff()).maxCoeff();
    m_cell_weights.resize(static_cast<Eigen::Index>(m_cells.size()));
    for(std::size_t t = 0; t < m_cells.size(); ++t)
    {
      const std::array<int, 4>& c = m_cells[t];
      for(const int v : c)
        if(v < 0 || v >= m_points.rows())
          throw std::invalid_argument("cell " + std::to_string(t) + " names vertex "
                                      + std::to_string(v) + ", but there are "
                                      + std::to_string(m_points.rows()));
      Eigen::Matrix3d edges;
      for(int k = 0; k < 3; ++k)
        edges.row(k) = (m_points.row(c[k + 1]) - m_points.row(c[0])) / size;
      m_cell_weights[t] = std::abs(edges.determinant()) / 6;
      if(!(m_cell_weights[t] > 0))
        throw std::invalid_argument("cell " + std::to_string(t) + " has no volume");
    }
    const double relative_volume = m_cell_weights.sum();
    m_cell_weights /= relative_volume;
    m_volume = relative_volume * size * size * size;
  }

  Point_matrix m_points;
  std::vector<std::array<int, 4>> m_cells;
  Eigen::SparseMatrix<double> m_embedding;
  Eigen::VectorXd m_cell_weights;
  double m_volume = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_EMBEDDED_BODY_3_H
