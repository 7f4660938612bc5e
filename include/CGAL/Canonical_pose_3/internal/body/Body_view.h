// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_BODY_BODY_VIEW_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_BODY_BODY_VIEW_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A model of ElasticBody_3 that refers to another one, so that slow-compiling code is compiled for
// a single type.
class Body_view
{
public:
  template <class ElasticBody>
  explicit Body_view(const ElasticBody& body)
    : Body_view(&body.points(), &body.cells(), &body.cell_weights(), body.volume(),
                &body.embedding())
  {}

  Body_view(const Point_matrix* points, const std::vector<std::array<int, 4>>* cells,
            const Eigen::VectorXd* cell_weights, const double volume,
            const Eigen::SparseMatrix<double>* embedding)
    : m_points(points), m_cells(cells), m_cell_weights(cell_weights), m_volume(volume),
      m_embedding(embedding)
  {}

  const Point_matrix& points() const { return *m_points; }
  const std::vector<std::array<int, 4>>& cells() const { return *m_cells; }
  const Eigen::VectorXd& cell_weights() const { return *m_cell_weights; }
  double volume() const { return m_volume; }
  const Eigen::SparseMatrix<double>& embedding() const { return *m_embedding; }

private:
  const Point_matrix* m_points;
  const std::vector<std::array<int, 4>>* m_cells;
  const Eigen::VectorXd* m_cell_weights;
  double m_volume;
  const Eigen::SparseMatrix<double>* m_embedding;
};

// Whether there is a view of a `T`.
template <class T, class = void>
struct Is_elastic_body : std::false_type
{};

template <class T>
struct Is_elastic_body<
  T, std::void_t<decltype(Body_view(
       &std::declval<const T&>().points(), &std::declval<const T&>().cells(),
       &std::declval<const T&>().cell_weights(), std::declval<const T&>().volume(),
       &std::declval<const T&>().embedding()))>> : std::true_type
{};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_BODY_BODY_VIEW_H
