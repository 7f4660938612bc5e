// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface_projection.h"
#include "../target/nearest_in_triangle.h"

#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>

#include <array>
#include <limits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Surface_projection::Surface_projection(const Matchable_data& shape, const Point_matrix& pose,
                                       const Point_matrix& normals)
  : m_shape(shape), m_pose(pose), m_normals(normals), m_search(pose),
    m_triangles(static_cast<std::size_t>(pose.rows()), [&](const auto& put) {
      for(std::size_t t = 0; t < shape.surface.triangles.size(); ++t)
        for(const std::size_t v : shape.surface.triangles[t])
          put(v, t);
    })
{}

std::vector<Surface_match_3::Location>
Surface_projection::locations(const Point_matrix& positions, const Point_matrix& normals) const
{
  constexpr std::size_t number_of_candidates = 8, most = 3;
  std::vector<Location> result(static_cast<std::size_t>(positions.rows()));
  const std::vector<std::vector<std::size_t>> nearest
    = m_search.nearest(positions, number_of_candidates);
  for_each_block(result.size(), [&](std::size_t, const std::size_t begin, const std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
    {
      const auto row = static_cast<Eigen::Index>(i);
      std::vector<std::size_t> rows;
      for(const std::size_t j : nearest[i])
        if(rows.size() < most
           && (normals.rows() == 0
               || normals.row(row).dot(m_normals.row(static_cast<Eigen::Index>(j))) > 0))
          rows.push_back(j);
      if(rows.empty())
        rows.push_back(nearest[i].front());
      result[i] = location(rows, positions.row(row).transpose());
    }
  });
  return result;
}

// On a triangle at one of `rows`.
Surface_match_3::Location Surface_projection::location(const std::vector<std::size_t>& rows,
                                                       const Eigen::Vector3d& position) const
{
  Location result = {};
  double least = (std::numeric_limits<double>::infinity)();
  for(const std::size_t row : rows)
    for(const std::size_t t : m_triangles[row])
    {
      const std::array<std::size_t, 3>& triangle = m_shape.surface.triangles[t];
      std::array<Eigen::Vector3d, 3> corners;
      for(std::size_t k = 0; k < 3; ++k)
        corners[k] = m_pose.row(static_cast<Eigen::Index>(triangle[k])).transpose();
      const std::array<double, 3> weights
        = nearest_in_triangle(position, corners[0], corners[1], corners[2]);
      const double distance
        = (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - position)
            .squaredNorm();
      if(distance < least)
      {
        least = distance;
        result.face = m_shape.surface.face_of_triangle[t];
        result.weights = weights;
        result.vertices = m_shape.corners[t];
      }
    }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
