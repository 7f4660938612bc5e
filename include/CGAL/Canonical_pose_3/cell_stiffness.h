// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CELL_STIFFNESS_H
#define CGAL_CANONICAL_POSE_3_CELL_STIFFNESS_H

#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief transfers a stiffness given on the surface to the cells of an elastic body.

The value of a body vertex is the mean over the surface vertices embedded in its cells, weighted by
their area shares and by their entries in the embedding; if there are none, it is the mean over the
neighbors that already have a value, ring by ring from the surface inward. The value of a cell is
the mean over its four vertices. Values are thus within the range of the given ones, and parts of
the body that are not connected do not mix, even if they are close.

\tparam ElasticBody a model of `ElasticBody_3`

\param body the body.
\param area_shares \f$ n \f$ weights of the surface vertices, see `vertex_area_shares()`.
\param stiffness \f$ n \f$ numbers in the range of weights, see `Registration_options::SMALLEST_WEIGHT`,
       one per surface vertex.

\returns one number per cell, as required by `Tetrahedral_arap_registrar_3`.

\pre `area_shares.size() == body.embedding().rows()`

\throws std::invalid_argument if there is not one number per vertex, or a number is out of
       range; the message states the index of the vertex.

<em>Complexity:</em> one pass over the cells per ring.
*/
template <class ElasticBody>
Eigen::VectorXd cell_stiffness(const ElasticBody& body, const Eigen::VectorXd& area_shares,
                               const Eigen::VectorXd& stiffness)
{
  const Eigen::SparseMatrix<double>& embedding = body.embedding();
  CGAL_precondition(area_shares.size() == embedding.rows());
  internal::check_factors(stiffness, embedding.rows(), "stiffness", "vertex", false);

  const Eigen::Index n = body.points().rows();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(n); // 0: no value yet
  for(Eigen::Index v = 0; v < n; ++v)
  {
    double sum = 0, weight = 0;
    for(Eigen::SparseMatrix<double>::InnerIterator it(embedding, v); it; ++it)
    {
      const double w = area_shares[it.row()] * std::abs(it.value());
      sum += w * stiffness[it.row()];
      weight += w;
    }
    if(weight > 0)
      values[v] = sum / weight;
  }

  for(bool is_complete = false; !is_complete;)
  {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(n), counts = Eigen::VectorXd::Zero(n);
    for(const std::array<int, 4>& cell : body.cells())
      for(const int v : cell)
        for(const int neighbor : cell)
          if(values[v] == 0 && values[neighbor] > 0)
          {
            sums[v] += values[neighbor];
            counts[v] += 1;
          }
    is_complete = counts.maxCoeff() == 0;
    for(Eigen::Index v = 0; v < n; ++v)
      if(counts[v] > 0)
        values[v] = sums[v] / counts[v];
  }

  Eigen::VectorXd result(static_cast<Eigen::Index>(body.cells().size()));
  for(std::size_t t = 0; t < body.cells().size(); ++t)
  {
    const std::array<int, 4>& cell = body.cells()[t];
    result[static_cast<Eigen::Index>(t)]
      = (values[cell[0]] + values[cell[1]] + values[cell[2]] + values[cell[3]]) / 4;
  }
  return result
    .cwiseMax(Registration_options::SMALLEST_WEIGHT) // rounded
    .cwiseMin(Registration_options::LARGEST_WEIGHT);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CELL_STIFFNESS_H
