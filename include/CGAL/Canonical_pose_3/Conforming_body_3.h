// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CONFORMING_BODY_3_H
#define CGAL_CANONICAL_POSE_3_CONFORMING_BODY_3_H

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an elastic body whose first vertices are those of the surface, in the same order.

Surface vertex \f$ i \f$ is body vertex \f$ i \f$, so the rows of the embedding matrix are rows of
the identity matrix; subsequent vertices (for instance Steiner points) are interior and have no
target. For a tetrahedral complex, all vertices are considered surface vertices here, interior ones
with matching weight 0.

\cgalModels `ElasticBody_3`

\sa `tetgen_body()`
\sa `Tetrahedral_arap_registrar_3`
*/
class Conforming_body_3 : public Embedded_body_3
{
public:
  /*!
  constructs the body.

  \param points \f$ N \times 3 \f$, rest positions of the body vertices.
  \param cells four rows of `points` per cell, in either orientation.
  \param number_of_surface_vertices number of leading rows that are surface vertices.

  \throws std::invalid_argument if `number_of_surface_vertices` exceeds the number of rows; see also
         `Embedded_body_3::Embedded_body_3()`.

  <em>Complexity:</em> linear.
  */
  Conforming_body_3(const Point_matrix& points, std::vector<std::array<int, 4>> cells,
                    const std::size_t number_of_surface_vertices)
    : Embedded_body_3(points, std::move(cells),
                      identity_rows(number_of_surface_vertices, points.rows()))
  {}

private:
  static Eigen::SparseMatrix<double> identity_rows(const std::size_t number,
                                                   const Eigen::Index columns)
  {
    if(number > static_cast<std::size_t>(columns))
      throw std::invalid_argument("there are " + std::to_string(number)
                                  + " surface vertices, but only " + std::to_string(columns)
                                  + " body vertices");
    const auto rows = static_cast<Eigen::Index>(number);
    Eigen::SparseMatrix<double> matrix(rows, columns);
    matrix.reserve(rows);
    for(Eigen::Index i = 0; i < rows; ++i)
      matrix.insert(i, i) = 1;
    matrix.makeCompressed();
    return matrix;
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CONFORMING_BODY_3_H
