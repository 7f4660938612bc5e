// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_BODY_ROWS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_BODY_ROWS_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Values at the vertices of a surface, transferred to the surface vertices of its body.
class Body_rows
{
public:
  Body_rows(const std::vector<std::size_t>& origins, const Eigen::Index n)
    : m_origins(origins), m_copies(Eigen::VectorXd::Zero(n))
  {
    for(const std::size_t row : origins)
      m_copies[static_cast<Eigen::Index>(row)] += 1;
  }

  Eigen::VectorXd sums(const Eigen::VectorXd& values) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(m_copies.size());
    for(std::size_t i = 0; i < m_origins.size(); ++i)
      result[static_cast<Eigen::Index>(m_origins[i])] += values[static_cast<Eigen::Index>(i)];
    return result;
  }

  // Copies of a vertex of the body have the same target.
  Point_matrix means(const Point_matrix& points) const
  {
    Point_matrix result = Point_matrix::Zero(m_copies.size(), 3);
    for(std::size_t i = 0; i < m_origins.size(); ++i)
      result.row(static_cast<Eigen::Index>(m_origins[i]))
        += points.row(static_cast<Eigen::Index>(i));
    return m_copies.cwiseMax(1).cwiseInverse().asDiagonal() * result;
  }

  std::vector<Index_triangle> triangles(std::vector<Index_triangle> triangles) const
  {
    for(Index_triangle& t : triangles)
      for(std::size_t& v : t)
        v = m_origins[v];
    return triangles;
  }

private:
  const std::vector<std::size_t>& m_origins;
  Eigen::VectorXd m_copies;
};

inline Eigen::VectorXd body_weights(const Body_rows& rows, const Eigen::VectorXd& shares,
                                    const Component_options& options)
{
  const Eigen::VectorXd weights
    = rows.sums(options.paper_weights ? Eigen::VectorXd::Ones(shares.size()).eval() : shares);
  if(options.matching_weights.size() == 0)
    return weights;
  return weights.cwiseProduct(options.matching_weights);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_BODY_ROWS_H
