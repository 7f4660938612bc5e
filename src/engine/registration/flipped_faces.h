// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_REGISTRATION_FLIPPED_FACES_H
#define CANONICAL_POSE_3_ENGINE_REGISTRATION_FLIPPED_FACES_H

#include "../energy/closest_rotation.h"

#include <CGAL/Canonical_pose_3/internal/body/body_cells.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Among the cells around the body vertex with the largest entry in the embedding of the first
// corner of a triangle, finds the cell with the most body vertices in which its corners are
// embedded.
template <class ElasticBody>
class Cell_of_triangle
{
public:
  explicit Cell_of_triangle(const ElasticBody& body)
    : m_cells(body.cells()), m_embedding(body.embedding()),
      m_cells_of_vertex(
        cells_of_vertices(static_cast<std::size_t>(body.points().rows()), body.cells()))
  {}

  std::size_t operator()(const Index_triangle& triangle) const
  {
    Entry main(m_embedding, static_cast<Eigen::Index>(triangle[0]));
    for(Entry entry = main; entry; ++entry)
      if(std::abs(entry.value()) > std::abs(main.value()))
        main = entry;
    boost::container::small_vector<int, 12> vertices; // up to four of each corner
    for(const std::size_t v : triangle)
      for(Entry entry(m_embedding, static_cast<Eigen::Index>(v)); entry; ++entry)
        if(entry.value() != 0)
          vertices.push_back(static_cast<int>(entry.col()));
    std::size_t best = 0;
    std::ptrdiff_t best_count = -1;
    const auto most = static_cast<std::ptrdiff_t>(vertices.size());
    const auto cells = m_cells_of_vertex[static_cast<std::size_t>(main.col())];
    for(auto t = cells.begin(); t != cells.end() && best_count < most; ++t)
    {
      std::ptrdiff_t count = 0;
      for(const int v : m_cells[*t])
        count += std::count(vertices.begin(), vertices.end(), v);
      if(count > best_count)
      {
        best = *t;
        best_count = count;
      }
    }
    return best;
  }

private:
  using Embedding = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Entry = Embedding::InnerIterator;

  const std::vector<std::array<int, 4>>& m_cells;
  Embedding m_embedding;
  Buckets<std::size_t> m_cells_of_vertex;
};

// Returns the number of surface faces whose normal is rotated by more than 90 degrees relative to
// the rotation of their cell.
template <class ElasticBody>
std::size_t flipped_faces(const ElasticBody& body, const std::vector<Index_triangle>& triangles,
                          const Point_matrix& rest, const Point_matrix& pose,
                          const Point_matrix& body_pose)
{
  const auto normal = [](const Point_matrix& points, const Index_triangle& t) {
    const Eigen::Vector3d e = points.row(t[1]) - points.row(t[0]);
    const Eigen::Vector3d f = points.row(t[2]) - points.row(t[0]);
    return Eigen::Vector3d(e.cross(f));
  };
  const Cell_of_triangle<ElasticBody> cell_of(body);
  std::vector<std::size_t> counts(number_of_blocks(triangles.size()), 0);
  for_each_block(
    triangles.size(), [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
      for(std::size_t f = begin; f < end; ++f)
      {
        const auto& c = body.cells()[cell_of(triangles[f])];
        Eigen::Matrix3d before, after;
        for(int k = 0; k < 3; ++k)
        {
          before.col(k) = body.points().row(c[k]) - body.points().row(c[3]);
          after.col(k) = body_pose.row(c[k]) - body_pose.row(c[3]);
        }
        const Eigen::Matrix3d rotation = closest_rotation(after * before.inverse());
        if(!((rotation * normal(rest, triangles[f])).dot(normal(pose, triangles[f])) > 0))
          ++counts[block];
      }
    });
  return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_REGISTRATION_FLIPPED_FACES_H
