// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_ELASTIC_BODY_3_H
#define CGAL_CANONICAL_POSE_3_ELASTIC_BODY_3_H

#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <array>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds a body of any type, which can thus be chosen at run time.

Copies share the body, which is never modified.

\cgalModels `ElasticBody_3`

\sa `Options::make_body`
*/
class Elastic_body_3
{
public:
  /// constructs from a body.
  /// \tparam ElasticBody a model of `ElasticBody_3`, move constructible
  template <
    class ElasticBody,
    std::enable_if_t<std::conjunction<std::negation<std::is_same<ElasticBody, Elastic_body_3>>,
                                      internal::Is_elastic_body<ElasticBody>>::value,
                     int> = 0>
  Elastic_body_3(ElasticBody body)
    : m_body(std::make_shared<const ElasticBody>(std::move(body))),
      m_view(*static_cast<const ElasticBody*>(m_body.get()))
  {}

  /// returns the rest positions of the body vertices.
  const Point_matrix& points() const { return m_view.points(); }

  /// returns the cells.
  const std::vector<std::array<int, 4>>& cells() const { return m_view.cells(); }

  /// returns the weights of the cells.
  const Eigen::VectorXd& cell_weights() const { return m_view.cell_weights(); }

  /// returns the volume.
  double volume() const { return m_view.volume(); }

  /// returns the embedding.
  const Eigen::SparseMatrix<double>& embedding() const { return m_view.embedding(); }

private:
  std::shared_ptr<const void> m_body;
  internal::Body_view m_view;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_ELASTIC_BODY_3_H
