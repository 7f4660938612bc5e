// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_FLIPPED_FACES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_FLIPPED_FACES_H

#include <CGAL/Canonical_pose_3/internal/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/closest_rotation.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// For each surface triangle the cell that has most of the body vertices on which its corners hang.
template <typename ElasticBody>
std::vector<std::size_t> cells_of_triangles(const ElasticBody& body,
                                            const std::vector<Index_triangle>& triangles)
{
  std::vector<std::vector<std::size_t>> cells_of_vertex(
    static_cast<std::size_t>(body.points().rows()));
  for(std::size_t t = 0; t < body.cells().size(); ++t)
    for(const int v : body.cells()[t])
      cells_of_vertex[static_cast<std::size_t>(v)].push_back(t);
  const Eigen::SparseMatrix<double, Eigen::RowMajor> embedding = body.embedding();
  typedef Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator Entry;

  std::vector<std::size_t> result;
  std::vector<int> support;
  for(const Index_triangle& triangle : triangles)
  {
    support.clear();
    for(const std::size_t v : triangle)
      for(Entry entry(embedding, static_cast<Eigen::Index>(v)); entry; ++entry)
        if(entry.value() != 0)
          support.push_back(static_cast<int>(entry.col()));
    std::size_t best = 0;
    std::ptrdiff_t best_count = -1;
    for(const int v : support)
      for(const std::size_t t : cells_of_vertex[static_cast<std::size_t>(v)])
      {
        const auto& cell = body.cells()[t];
        const std::ptrdiff_t count
          = std::count_if(support.begin(), support.end(), [&](const int s) {
              return std::find(cell.begin(), cell.end(), s) != cell.end();
            });
        if(count > best_count || (count == best_count && t < best))
        {
          best = t;
          best_count = count;
        }
      }
    result.push_back(best);
  }
  return result;
}

// Number of surface faces whose normal turned by more than 90 degrees against the rotation of their
// cell.
template <typename ElasticBody>
std::size_t flipped_faces(const ElasticBody& body, const std::vector<Index_triangle>& triangles,
                          const Point_matrix& rest, const Point_matrix& pose,
                          const Point_matrix& body_pose)
{
  const auto normal = [](const Point_matrix& points, const Index_triangle& t) {
    const Eigen::Vector3d e = points.row(t[1]) - points.row(t[0]);
    const Eigen::Vector3d f = points.row(t[2]) - points.row(t[0]);
    return Eigen::Vector3d(e.cross(f));
  };
  const std::vector<std::size_t> cells = cells_of_triangles(body, triangles);
  std::size_t count = 0;
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    const auto& c = body.cells()[cells[f]];
    Eigen::Matrix3d before, after;
    for(int k = 0; k < 3; ++k)
    {
      before.col(k) = body.points().row(c[k]) - body.points().row(c[3]);
      after.col(k) = body_pose.row(c[k]) - body_pose.row(c[3]);
    }
    const Eigen::Matrix3d rotation = closest_rotation<>(after * before.inverse());
    if(!((rotation * normal(rest, triangles[f])).dot(normal(pose, triangles[f])) > 0))
      ++count;
  }
  return count;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_FLIPPED_FACES_H
