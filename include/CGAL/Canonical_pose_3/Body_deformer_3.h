// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BODY_DEFORMER_3_H
#define CGAL_CANONICAL_POSE_3_BODY_DEFORMER_3_H

#include <CGAL/Canonical_pose_3/internal/body/body_cells.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_tree.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief applies the deformation of an elastic body to points near its surface, such as markers, a
point cloud, or a finer version of the surface.

A point is embedded in one of the cells around the nearest location on the surface: in the cell that
contains it, or, if there is none, in the nearest one in barycentric coordinates. If there are
several, the cell that contributes most to this location is chosen. Points thus follow the part of
the body that they lie on, even if another part is close by, and a point at a vertex of the surface
moves with this vertex.

\tparam ElasticBody a model of `ElasticBody_3`

\sa `Tetrahedral_arap_registrar_3`
*/
template <class ElasticBody>
class Body_deformer_3
{
public:
  /// the body
  using Elastic_body = ElasticBody;

  /*!
  constructs a deformer.

  \param body the body, not a temporary. It must outlive the deformer.
  \param triangles the surface: triples of rows of `body.embedding()`. Degenerate triangles are
         ignored: a point near such a triangle is equally near to its neighbors.

  \throws std::invalid_argument if a triangle has an invalid row, or all triangles are degenerate.

  <em>Complexity:</em> \f$ O(n \log n) \f$.
  */
  Body_deformer_3(const ElasticBody& body, const std::vector<std::array<std::size_t, 3>>& triangles)
    : m_body(body), m_embedding(body.embedding()),
      m_cells_of_vertex(
        internal::cells_of_vertices(static_cast<std::size_t>(body.points().rows()), body.cells())),
      m_triangles(checked(triangles, static_cast<std::size_t>(body.embedding().rows()))),
      m_tree(body.embedding() * body.points(), triangles), m_points(body.points())
  {
    for(Eigen::Index i = 0; i < m_points.rows(); ++i)
      m_points.row(i) = m_tree.normalized(m_points.row(i));
  }

  /// \cond SKIP_IN_MANUAL
  Body_deformer_3(const ElasticBody&&, const std::vector<std::array<std::size_t, 3>>&) = delete;
  /// \endcond

  /*!
  returns the \f$ m \times N \f$ matrix that embeds the points in the body: its product with the
  body vertices in the pose is the pose of the points. The entries of a row sum to 1.

  \param points \f$ m \times 3 \f$, at rest.

  \throws std::invalid_argument if a coordinate is not finite.

  <em>Complexity:</em> \f$ O(m \log n) \f$.
  */
  Eigen::SparseMatrix<double> embedding(const Point_matrix& points) const
  {
    internal::check_finite(points);
    std::vector<Row> rows(static_cast<std::size_t>(points.rows()));
    internal::for_each_block(
      rows.size(),
      [&](std::size_t, const std::size_t begin, const std::size_t end) {
        for(std::size_t i = begin; i < end; ++i)
          rows[i] = embed(m_tree.normalized(points.row(static_cast<Eigen::Index>(i))));
      },
      64);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * rows.size());
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(int k = 0; k < 4; ++k)
        if(rows[i].coordinates[k] != 0)
          entries.emplace_back(static_cast<int>(i),
                               m_body.cells()[rows[i].cell][static_cast<std::size_t>(k)],
                               rows[i].coordinates[k]);
    Eigen::SparseMatrix<double> result(points.rows(), m_body.points().rows());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

private:
  static const std::vector<std::array<std::size_t, 3>>&
  checked(const std::vector<std::array<std::size_t, 3>>& triangles, const std::size_t n)
  {
    internal::check_elements(triangles, n);
    return triangles;
  }

  struct Row
  {
    std::size_t cell;
    Eigen::Vector4d coordinates;
  };

  Eigen::Vector4d coordinates_in(const std::size_t cell, const Eigen::RowVector3d& point) const
  {
    std::array<Eigen::Vector3d, 4> corners;
    for(std::size_t k = 0; k < 4; ++k)
      corners[k] = m_points.row(m_body.cells()[cell][k]);
    return internal::barycentric_coordinates(corners, point);
  }

  // The body vertices in which a location on the surface is embedded, with their weights.
  std::map<int, double> support_of(const internal::Triangle_tree::Location& location) const
  {
    std::map<int, double> support;
    for(std::size_t k = 0; k < 3; ++k)
      for(typename Embedding::InnerIterator entry(
            m_embedding, static_cast<Eigen::Index>(m_triangles[location.triangle][k]));
          entry; ++entry)
        if(entry.value() != 0)
          support[static_cast<int>(entry.col())]
            += location.coordinates[static_cast<Eigen::Index>(k)] * entry.value();
    return support;
  }

  // Cells of several parts of the body may surround the point. Among those that are about equally
  // near, the one that contributes most to the location on the surface belongs to the right part.
  Row embed(const Eigen::RowVector3d& point) const
  {
    const std::map<int, double> support = support_of(m_tree.nearest(point));
    std::vector<std::size_t> cells;
    for(const auto& [vertex, weight] : support)
    {
      const auto& around = m_cells_of_vertex[static_cast<std::size_t>(vertex)];
      cells.insert(cells.end(), around.begin(), around.end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    Row best{0, Eigen::Vector4d::Zero()};
    double least_outside = std::numeric_limits<double>::infinity(), largest_share = 0;
    for(const std::size_t cell : cells)
    {
      const Eigen::Vector4d coordinates = coordinates_in(cell, point);
      const double outside = (std::max)(-coordinates.minCoeff(), 0.);
      double share = 0;
      for(const int v : m_body.cells()[cell])
      {
        const auto found = support.find(v);
        share += found != support.end() ? found->second : 0;
      }
      if(outside < least_outside - TOLERANCE
         || (outside <= least_outside + TOLERANCE
             && (share > largest_share + TOLERANCE
                 || (share >= largest_share - TOLERANCE
                     && coordinates.minCoeff() > best.coordinates.minCoeff()))))
      {
        least_outside = outside;
        largest_share = share;
        best = {cell, coordinates};
      }
    }
    return best;
  }

  static constexpr double TOLERANCE = 1e-9;

  using Embedding = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  const ElasticBody& m_body;
  Embedding m_embedding;
  internal::Buckets<std::size_t> m_cells_of_vertex;
  std::vector<std::array<std::size_t, 3>> m_triangles;
  internal::Triangle_tree m_tree;
  Point_matrix m_points; // of the body, in the unit of the tree
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_BODY_DEFORMER_3_H
