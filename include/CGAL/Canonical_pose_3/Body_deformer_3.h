// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_BODY_DEFORMER_3_H
#define CGAL_CANONICAL_POSE_3_BODY_DEFORMER_3_H

#include <CGAL/Canonical_pose_3/internal/body_cells.h>
#include <CGAL/Canonical_pose_3/internal/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief applies the deformation of an elastic body to points near its surface, such as markers, a point
cloud, or a finer version of the surface.

A point hangs on the cell that contains it, of those around the nearest triangle of the surface; if
none does, on the cell that it is nearest to in barycentric coordinates. So the points follow the part
of the body that they lie on, however near another part may be.

\tparam ElasticBody a model of `ElasticBody_3`

\sa `Tetrahedral_arap_registrar_3`
*/
template <typename ElasticBody>
class Body_deformer_3
{
public:
  /*!
  constructs a deformer.

  \param body the body; it must outlive the deformer.
  \param triangles the surface: triples of rows of `body.embedding()`. Flat ones are not looked at: a
         point near one of these is as near to its neighbors.

  \throws std::invalid_argument if no triangle has an area.

  <em>Complexity:</em> \f$ O(n \log n) \f$.
  */
  Body_deformer_3(const ElasticBody& body, const std::vector<std::array<std::size_t, 3>>& triangles)
    : m_body(body), m_embedding(body.embedding()),
      m_cells_of_vertex(
        internal::cells_of_vertices(static_cast<std::size_t>(body.points().rows()), body.cells()))
  {
    Point_matrix surface = body.embedding() * body.points();
    m_exponent = internal::normalize(surface);
    const auto row = [&](const std::size_t v) -> Eigen::RowVector3d {
      return surface.row(static_cast<Eigen::Index>(v));
    };
    for(const auto& t : triangles)
    {
      const double longest
        = (std::max)({(row(t[1]) - row(t[0])).squaredNorm(), (row(t[2]) - row(t[1])).squaredNorm(),
                      (row(t[0]) - row(t[2])).squaredNorm()});
      if(internal::twice_area(surface, t) > FLATNESS * longest)
        m_triangles.push_back(
          {Kernel::Triangle_3(point(row(t[0])), point(row(t[1])), point(row(t[2]))), t});
    }
    if(m_triangles.empty())
      throw std::invalid_argument("no triangle of the surface has an area");
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
  }

  /*!
  returns the matrix \f$ m \times N \f$ that says how points hang on the body: its product with the
  body vertices in the pose is the pose of the points. The entries of a row sum to 1.

  \param points \f$ m \times 3 \f$, at rest.

  \throws std::invalid_argument if a coordinate is not finite.

  <em>Complexity:</em> \f$ O(m \log n) \f$.
  */
  Eigen::SparseMatrix<double> embedding(const Point_matrix& points) const
  {
    internal::check_finite(points);
    std::vector<Row> rows(static_cast<std::size_t>(points.rows()));
    for(std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = embed(normalized(points.row(static_cast<Eigen::Index>(i))));
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
  typedef Simple_cartesian<double> Kernel;
  typedef Kernel::Point_3 Point;

  static constexpr double FLATNESS = 1e-10; // of what has no plane to speak of
  static constexpr double FARTHEST = 1e100; // in sizes of the surface, so that no square overflows

  static Point point(const Eigen::RowVector3d& row) { return Point(row[0], row[1], row[2]); }

  Eigen::RowVector3d normalized(const Eigen::RowVector3d& row) const
  {
    return row.unaryExpr([this](const double x) {
      return (std::max)(-FARTHEST, (std::min)(std::ldexp(x, -m_exponent), FARTHEST));
    });
  }

  struct Surface_triangle
  {
    Kernel::Triangle_3 triangle;
    std::array<std::size_t, 3> vertices;
  };

  struct Triangle_primitive
  {
    typedef const Surface_triangle* Id;
    typedef Kernel::Point_3 Point;
    typedef Kernel::Triangle_3 Datum;

    Triangle_primitive() = default;
    explicit Triangle_primitive(
      const typename std::vector<Surface_triangle>::const_iterator triangle)
      : m_triangle(&*triangle)
    {}
    Id id() const { return m_triangle; }
    const Datum& datum() const { return m_triangle->triangle; }
    const Point& reference_point() const { return m_triangle->triangle.vertex(0); }

    Id m_triangle = nullptr;
  };
#if CGAL_VERSION_NR >= 1060000000
  typedef AABB_tree<AABB_traits_3<Kernel, Triangle_primitive>> Tree;
#else
  typedef AABB_tree<AABB_traits<Kernel, Triangle_primitive>> Tree;
#endif

  struct Row
  {
    std::size_t cell;
    Eigen::Vector4d coordinates;
  };

  Eigen::Vector4d coordinates_in(const std::size_t cell, const Eigen::RowVector3d& point) const
  {
    std::array<Eigen::Vector3d, 4> corners;
    for(std::size_t k = 0; k < 4; ++k)
      corners[k] = normalized(m_body.points().row(m_body.cells()[cell][k]));
    return internal::barycentric_coordinates(corners, point);
  }

  Row embed(const Eigen::RowVector3d& place) const
  {
    const auto nearest = m_tree.closest_point_and_primitive(point(place)).second;
    std::vector<std::size_t> cells;
    for(const std::size_t v : nearest->vertices)
      for(typename Embedding::InnerIterator entry(m_embedding, static_cast<Eigen::Index>(v)); entry;
          ++entry)
        if(entry.value() != 0)
        {
          const auto& around = m_cells_of_vertex[static_cast<std::size_t>(entry.col())];
          cells.insert(cells.end(), around.begin(), around.end());
        }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    Row best{0, Eigen::Vector4d::Zero()};
    double best_minimum = -std::numeric_limits<double>::infinity();
    for(const std::size_t cell : cells)
    {
      const Eigen::Vector4d coordinates = coordinates_in(cell, place);
      if(coordinates.minCoeff() > best_minimum)
      {
        best_minimum = coordinates.minCoeff();
        best = {cell, coordinates};
      }
    }
    return best;
  }

  typedef Eigen::SparseMatrix<double, Eigen::RowMajor> Embedding;

  const ElasticBody& m_body;
  int m_exponent = 0; // places are in the unit of the body by 2 to this power
  Embedding m_embedding;
  internal::Buckets<std::size_t> m_cells_of_vertex;
  std::vector<Surface_triangle> m_triangles;
  Tree m_tree;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_BODY_DEFORMER_3_H
