// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_CONFORMING_BODY_3_H
#define CGAL_CANONICAL_POSE_3_CONFORMING_BODY_3_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

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

\brief is an elastic body among whose vertices are those of the surface: the first ones, in their
order.

Surface vertex \f$ i \f$ is body vertex \f$ i \f$, so that the embedding matrix has identity rows;
vertices that follow (Steiner points, say) belong to the interior and have no target. Of a
tetrahedral complex all vertices count as surface vertices here, those inside with matching weight
0.

\cgalModels `ElasticBody_3`

\sa `tetgen_body()`
\sa `Tetrahedral_arap_registrar_3`
*/
class Conforming_body_3
{
public:
  /*!
  constructs the body.

  \param points \f$ N \times 3 \f$, rest positions of the body vertices.
  \param cells four rows of `points` per cell, in either orientation.
  \param number_of_surface_vertices the first so many rows are the surface.

  \throws std::invalid_argument if there is no cell, a cell names a row that does not exist or names
         one twice, a coordinate is not finite, or a cell has no volume; the message names the
         element.

  <em>Complexity:</em> linear.
  */
  Conforming_body_3(Point_matrix points, std::vector<std::array<int, 4>> cells,
                    const std::size_t number_of_surface_vertices)
    : m_points(std::move(points)), m_cells(std::move(cells))
  {
    const Eigen::Index n = static_cast<Eigen::Index>(number_of_surface_vertices);
    CGAL_precondition(n <= m_points.rows());
    if(m_cells.empty())
      throw std::invalid_argument("the body has no cell");
    internal::check_finite(m_points);
    m_embedding.resize(n, m_points.rows());
    m_embedding.reserve(n);
    for(Eigen::Index i = 0; i < n; ++i)
      m_embedding.insert(i, i) = 1;
    m_embedding.makeCompressed();
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

  /// returns the \f$ n \times N \f$ matrix \f$ B \f$ with identity rows.
  const Eigen::SparseMatrix<double>& embedding() const { return m_embedding; }

private:
  void measure_cells()
  {
    const double size = (m_points.colwise().maxCoeff() - m_points.colwise().minCoeff()).norm();
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
  Eigen::VectorXd m_cell_weights;
  Eigen::SparseMatrix<double> m_embedding;
  double m_volume = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CONFORMING_BODY_3_H
